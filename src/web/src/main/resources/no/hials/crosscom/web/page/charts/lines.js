// The list of lines: the numbers of the chosen variables, each of which can be shown or hidden.

import { h } from 'preact';
import { valueAt } from './tracks.js';

/** The rows of the list: more would make each rendering slow. */
export const MAX_ROWS = 200;

function number(value) {
  if (Number.isNaN(value)) {
    return '–';
  }
  if (Number.isInteger(value)) {
    return String(value);
  }
  const digits = Math.abs(value) < 10 ? 4 : 2;
  return (Number(value.toFixed(digits)) + 0).toFixed(digits); // without -0
}

/** Returns whether a name has the text of a filter. */
export function matches(name, filter) {
  return name.toUpperCase().includes(filter.trim().toUpperCase());
}

function Line({ picture, leaf, title, unit, line, onShow }) {
  return h(
    'label',
    { class: 'line' },
    h('input', {
      type: 'checkbox',
      checked: line !== undefined,
      onChange: (event) => onShow(leaf, event.target.checked),
    }),
    h('span', { class: `swatch ${line ? line.colour.slice(2) : 'none'}` }),
    h('span', { class: 'part' }, title),
    h('span', { class: 'reading' }, number(valueAt(picture.source.track(leaf), picture.time()))),
    h('span', { class: 'unit' }, unit),
  );
}

/** The numbers of the chosen variables, each of which can be shown or hidden. */
export function Lines({ picture, names, leaves: all, units, panels, first, filter, stale, onFilter, onShow, onRemove }) {
  const shown = new Map([...panels.values()].flat().map((line) => [line.leaf, line]));
  const isMany = all.length > MAX_ROWS;
  const found = all.filter((leaf) => matches(leaf, filter));
  const isListed = (leaf) => shown.has(leaf) || first.has(leaf);
  const inOrder = [...found.filter(isListed), ...found.filter((leaf) => !isListed(leaf))];
  const rows = new Set(inOrder.slice(0, MAX_ROWS));
  const left = found.length - rows.size;
  return h(
    'section',
    { class: `panel lines ${stale ? 'stale' : ''}`, 'aria-label': 'Lines' },
    isMany &&
      h('input', {
        type: 'search',
        placeholder: 'Filter',
        'aria-label': 'Filter the lines',
        value: filter,
        onInput: (event) => onFilter(event.target.value),
      }),
    isMany && h('p', { class: 'hint' }, `${found.length} found.${left > 0 ? ` The first ${MAX_ROWS} are listed.` : ''}`),
    names.map((name) => {
      const known = picture.source.leaves(name);
      const leaves = known.filter((leaf) => rows.has(leaf));
      if (known.length > leaves.length && leaves.length === 0) {
        return null;
      }
      const skipped = name.replace(/\[\]$/, '').length;
      const hidden = leaves.filter((leaf) => !isListed(leaf));
      // a single row needs as much room as the summary, and what was searched is not hidden
      const others = hidden.length > 1 && filter === '' ? hidden : [];
      const row = (leaf) =>
        h(Line, {
          key: leaf,
          picture,
          leaf,
          title: leaf === name ? 'value' : leaf.slice(skipped),
          unit: units.get(leaf) ?? '',
          line: shown.get(leaf),
          onShow,
        });
      return h(
        'fieldset',
        { key: name },
        h(
          'legend',
          null,
          h('span', { class: 'variable' }, name),
          onRemove &&
            h(
              'button',
              { class: 'quiet', 'aria-label': `Remove ${name}`, onClick: () => onRemove(name) },
              '×',
            ),
        ),
        leaves.length === 0 && h('p', { class: 'hint' }, picture.source.error?.(name) ?? 'No number.'),
        leaves.filter((leaf) => !others.includes(leaf)).map(row),
        others.length > 0 &&
          h(
            'details',
            null,
            h('summary', null, `${others.length} more`),
            others.map(row),
          ),
      );
    }),
  );
}
