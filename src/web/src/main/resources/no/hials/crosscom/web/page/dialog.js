// A dialog over the page: the <dialog> element keeps the focus inside, and Escape closes it.

import { h } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { withdraw } from './socket.js';
import { note } from './state.js';

/** Shows its children in a dialog while it is rendered. */
export function Dialog({ title, onClose, children }) {
  const element = useRef(null);
  const gone = useRef(false);
  useEffect(() => {
    const dialog = element.current;
    dialog.showModal();
    return () => {
      gone.current = true;
      dialog.close(); // the focus goes back to where it was
    };
  }, []);
  return h(
    'dialog',
    { ref: element, 'aria-label': title, onClose: () => gone.current || onClose() },
    h('h2', null, title),
    children,
  );
}

/**
 * Lets a dialog make a change. It is withdrawn if the dialog disappears before the answer, also
 * because the person goes to another view; a failure is then a note on the page.
 *
 * @returns busy, error (a text), close, and make: calls a function that sends something, unless it
 *     is busy, and returns whether that succeeded and the dialog is still there
 */
export function useChange(onClose) {
  const [busy, setBusy] = useState(false);
  const [error, setError] = useState('');
  const { current: now } = useRef({ busy: false, gone: false });
  const leave = () => {
    if (now.busy && !now.gone) {
      withdraw();
    }
    now.gone = true;
  };
  useEffect(() => leave, []);
  const close = () => {
    leave();
    onClose();
  };
  const make = async (work) => {
    if (now.busy) {
      return false;
    }
    now.busy = true;
    setBusy(true);
    setError('');
    try {
      await work();
      return !now.gone;
    } catch (e) {
      if (now.gone) {
        note('error', e.message);
      }
      setError(e.message);
      return false;
    } finally {
      now.busy = false;
      setBusy(false);
    }
  };
  return { busy, error, close, make };
}
