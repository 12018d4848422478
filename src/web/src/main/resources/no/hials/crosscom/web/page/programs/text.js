// The text of a module with its line numbers, and the running line. The page has only the visible
// lines, so that thousands of lines stay fast. The text comes from a controller: it is never
// made into markup.

import { h } from 'preact';
import { useEffect, useLayoutEffect, useMemo, useRef, useState } from 'preact/hooks';
import { call } from '../socket.js';
import { state } from '../state.js';

const LINE_HEIGHT = 20; // px, as in the style
const MORE_LINES = 20; // beyond the visible ones

/** Loads the text of a module, and reloads it when the version changes. */
function useText(name, version, bridge) {
  const [loaded, setLoaded] = useState({ name: '', text: '', error: '' });
  useEffect(() => {
    if (!name || !bridge) {
      setLoaded({ name: '', text: '', error: '' });
      return undefined;
    }
    let wanted = true;
    call('program-text', { robot: state.robot, name })
      .then(({ text }) => wanted && setLoaded({ name, text, error: '' }))
      .catch((e) => wanted && setLoaded({ name, text: '', error: e.message }));
    return () => (wanted = false);
  }, [name, version, bridge, state.socket]);
  return loaded;
}

/** Shows the lines of a text; scrolls to the running one unless the user reads elsewhere. */
function Lines({ name, text, pointer, main }) {
  const box = useRef(null);
  const own = useRef(0); // the position to which this component scrolled
  const [top, setTop] = useState(0);
  const [height, setHeight] = useState(600);
  const [following, setFollowing] = useState(true);
  const lines = useMemo(() => text.split(/\r\n|\r|\n/), [text]);
  const first = Math.max(0, Math.floor(top / LINE_HEIGHT) - MORE_LINES);
  const last = Math.min(lines.length, Math.ceil((top + height) / LINE_HEIGHT) + MORE_LINES);

  useLayoutEffect(() => setHeight(box.current.clientHeight), [text]);
  useLayoutEffect(() => {
    const element = box.current;
    const at = (pointer - 1) * LINE_HEIGHT;
    const visible =
      at >= element.scrollTop + LINE_HEIGHT &&
      at <= element.scrollTop + element.clientHeight - 3 * LINE_HEIGHT;
    if (following && pointer > 0 && !visible) {
      element.scrollTop = at - element.clientHeight / 2;
      own.current = element.scrollTop;
      setTop(element.scrollTop);
    }
  }, [pointer, following, text]);

  const scrolled = () => {
    const element = box.current;
    if (!element) {
      return; // the view is being left
    }
    setTop(element.scrollTop);
    setHeight(element.clientHeight);
    if (Math.abs(element.scrollTop - own.current) > 2) {
      own.current = element.scrollTop;
      setFollowing(false);
    }
  };
  return [
    pointer > 0 &&
      !following &&
      h(
        'button',
        { key: 'follow', class: 'follow', onClick: () => setFollowing(true) },
        `Follow line ${pointer}`,
      ),
    h(
      'div',
      {
        key: 'code',
        class: 'code',
        ref: box,
        tabIndex: 0,
        role: 'region',
        'aria-label': `Text of ${name}`,
        onScroll: scrolled,
      },
      h(
        'div',
        { class: 'all-lines', style: { height: `${lines.length * LINE_HEIGHT}px` } },
        h(
          'div',
          { class: 'some-lines', style: { top: `${first * LINE_HEIGHT}px` } },
          lines.slice(first, last).map((line, i) => {
            const number = first + i + 1;
            const kind = number === pointer ? 'running' : number === main ? 'main-run' : '';
            return h(
              'div',
              { key: number, class: `line ${kind}`, 'aria-current': kind === 'running' ? 'step' : undefined },
              h('span', { class: 'number' }, number),
              h('span', { class: 'krl' }, line),
            );
          }),
        ),
      ),
    ),
  ];
}

/** Returns a text of a structure without blanks; empty if it is not a text. */
function textOf(value) {
  return typeof value === 'string' ? value.trim() : '';
}

/** The modules that called each other, the innermost first. */
function callStack(pointer) {
  return Object.entries(pointer)
    .filter(([name]) => /^SI\d\d$/.test(name))
    .map(([, one]) => one)
    .filter((one) => textOf(one?.['NAME[]']) && one.SNR > 0);
}

/**
 * Shows the module in which the program pointer of an interpreter is, or a file.
 *
 * @param pointer the value of $PRO_IP1 or $PRO_IP0; undefined while it is unknown
 * @param stale whether it may no longer be true
 * @param file the file to show in its place; empty for the running module
 */
export function ModuleText({ known, pointer, stale, error, interpreter, onInterpreter, file, onCloseFile, version }) {
  const module = textOf(pointer?.['NAME[]']);
  const name = file || module;
  const found = useText(name, version, known?.bridge);
  const loaded = found.name === name ? found : { name, text: '', error: '' };
  const isRunning = !file && loaded.name === module && loaded.text;
  const line = isRunning ? pointer.SNR : 0;
  const main = isRunning && textOf(pointer['NAME_C[]']) === module ? pointer.SNR_C : 0;
  const stack = file || !pointer ? [] : callStack(pointer);
  return h(
    'section',
    { class: `panel text ${stale ? 'stale' : ''}`, 'aria-label': 'Text of the module' },
    h(
      'div',
      { class: 'text-tools' },
      h('h2', { class: 'variable' }, name || 'No module'),
      line > 0 && h('span', { class: 'hint reading' }, `line ${line}`),
      file
        ? h('button', { onClick: onCloseFile }, 'Back to the running module')
        : h(
            'div',
            { class: 'choice', role: 'group', 'aria-label': 'Interpreter' },
            ['robot', 'submit'].map((one) =>
              h(
                'button',
                { key: one, 'aria-pressed': String(one === interpreter), onClick: () => onInterpreter(one) },
                one,
              ),
            ),
          ),
    ),
    stack.length > 1 &&
      h(
        'p',
        { class: 'hint' },
        'Called by ',
        h('span', { class: 'reading' }, stack.slice(1).map((one) => `${textOf(one['NAME[]'])} line ${one.SNR}`).join(', ')),
      ),
    known?.bridge === false &&
      h(
        'p',
        { class: 'hint' },
        module && h('span', { class: 'reading' }, `The program pointer is in line ${pointer.SNR} of ${module}. `),
        'KUKAVARPROXY has no files: the text is on the pendant only.',
      ),
    error && h('p', { class: 'failure' }, `The program pointer cannot be read: ${error}`),
    loaded.error && h('p', { class: 'failure' }, loaded.error),
    loaded.text && h(Lines, { key: name, name, text: loaded.text, pointer: line, main }),
    main > 0 && main !== line &&
      h('p', { class: 'hint' }, `The marked line is where the program is planned (SNR); line ${main} is being executed (SNR_C, assumed).`),
    known?.bridge && !name && h('p', { class: 'hint' }, 'Select a program to see its text here.'),
  );
}
