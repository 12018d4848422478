// Values of variables as text. They come from a controller and are never made into markup.

import { h } from 'preact';

const HUGE = 1e7; // larger than any axis or position

/** Returns a value as text for people. */
export function valueText({ type, value, error }) {
  if (error !== undefined) {
    return error;
  }
  if (Array.isArray(value)) {
    return value.map((one) => scalarText(type, one)).join('  ');
  }
  return scalarText(type, value);
}

function scalarText(type, value) {
  if (value !== null && typeof value === 'object') {
    return Object.entries(value)
      .map(([name, field]) => `${name} ${scalarText('', field)}`)
      .join('  ');
  }
  if (typeof value === 'boolean') {
    return value ? 'TRUE' : 'FALSE';
  }
  // a whole REAL keeps its decimal place, so that the text does not jump when it changes
  return type === 'REAL' && Number.isInteger(value) ? `${value}.0` : String(value);
}

/** Returns a number with its unit, never -0; a dash for anything else. */
export function numberText(value, digits, unit = '') {
  if (!Number.isFinite(value)) {
    return '–';
  }
  const scale = 10 ** digits;
  const text =
    Math.abs(value) < HUGE ? (Math.round(value * scale) / scale + 0).toFixed(digits) : value.toPrecision(3);
  return unit ? `${text} ${unit}` : text;
}

/** Returns a number of the header, which is a text, in percent; a dash for anything else. */
export function percentText(text) {
  return text && Number.isFinite(Number(text)) ? `${text} %` : '–';
}

/** Shows a value; a structure becomes a small table of its fields. */
export function Value({ reading }) {
  if (reading === undefined) {
    return h('span', { class: 'none' }, '…');
  }
  if (reading.error !== undefined) {
    return h('span', { class: 'failure' }, reading.error);
  }
  const { value } = reading;
  if (value !== null && typeof value === 'object' && !Array.isArray(value)) {
    return h(
      'span',
      { class: 'fields' },
      Object.entries(value).map(([name, field]) =>
        h(
          'span',
          { key: name, class: 'field' },
          h('span', { class: 'field-name' }, name),
          h('span', { class: 'field-value' }, scalarText('', field)),
        ),
      ),
    );
  }
  return h('span', { class: 'scalar' }, valueText(reading));
}
