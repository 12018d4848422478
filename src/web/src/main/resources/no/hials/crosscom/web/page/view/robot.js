import { h } from 'preact';

export function View() {
  return h('section', { class: 'panel' }, h('h1', null, '3-D view'), h('p', null, 'Nothing here yet.'));
}
