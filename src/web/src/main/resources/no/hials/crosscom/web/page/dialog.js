// A dialog over the page: the <dialog> element keeps the focus inside, and Escape closes it.

import { h } from 'preact';
import { useEffect, useRef } from 'preact/hooks';

/** Shows its children in a dialog while it is rendered. */
export function Dialog({ title, onClose, children }) {
  const element = useRef(null);
  useEffect(() => {
    element.current.showModal();
  }, []);
  return h(
    'dialog',
    { ref: element, 'aria-label': title, onClose },
    h('h2', null, title),
    children,
  );
}
