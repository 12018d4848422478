// A button that moves the robot while it is held, by a finger, the mouse, Space or Enter.

import { h } from 'preact';
import { useEffect } from 'preact/hooks';
import { held, press, release } from './hold.js';

const KEYS = [' ', 'Enter'];

const device = (event) => event.pointerType || 'mouse';

export function JogButton({ name, direction, positive, percent, step, disabled }) {
  const isOurs = (one) => one.fields.direction === direction && one.fields.positive === positive;
  const own = held().find(isOurs);
  const begin = (source) => press(source, { direction, positive, percent, step });
  const source = () => held().find(isOurs)?.source; // `own` is that of the last rendering
  const end = () => source() && release(direction);
  // a second finger on another button takes the focus, and the first one still holds
  const blur = (event) => {
    if (source() === 'key' || !event.relatedTarget?.matches('.hold')) {
      end();
    }
  };
  useEffect(() => end, []);
  useEffect(() => {
    if (disabled) {
      end();
    }
  }, [disabled]);
  const down = (event) => {
    if (event.button === 0 && !disabled) {
      event.preventDefault();
      event.currentTarget.setPointerCapture(event.pointerId);
      // before the focus ends the hold of a key: of + and - of one direction, both must end
      begin(device(event));
      event.currentTarget.focus();
    }
  };
  // while another button of the mouse is down, a release of the left one is only a move
  const move = (event) => {
    if (!(event.buttons & 1) && source() === device(event)) {
      end();
    }
  };
  const keyDown = (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) {
      // macOS tells no release of another key while Cmd is down
      if (source() === 'key') {
        end();
      }
    } else if (KEYS.includes(event.key)) {
      event.preventDefault();
      if (!event.repeat && !disabled) {
        begin('key');
      }
    }
  };
  const keyUp = (event) => {
    if (KEYS.includes(event.key)) {
      event.preventDefault();
      end();
    }
  };
  return h(
    'button',
    {
      type: 'button',
      class: `hold ${own ? 'held' : ''} ${own?.moving ? 'moving' : ''}`,
      'aria-label': `Hold to move ${name} ${positive ? 'plus' : 'minus'}`,
      'aria-pressed': String(Boolean(own)),
      'aria-disabled': String(disabled),
      onPointerDown: down,
      onPointerMove: move,
      onPointerUp: end,
      onPointerCancel: end,
      onLostPointerCapture: end,
      onKeyDown: keyDown,
      onKeyUp: keyUp,
      onBlur: blur,
      onContextMenu: (event) => event.preventDefault(),
    },
    positive ? '+' : '−',
  );
}
