// The view of programs: interpreters, the text with the running line, messages, files, and the
// causes for a robot that stands still.

import { h } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { Checks } from '../programs/checks.js';
import { Confirm } from '../programs/confirm.js';
import { Files } from '../programs/files.js';
import { Interpreters } from '../programs/interpreters.js';
import { Messages } from '../programs/messages.js';
import { ModuleText } from '../programs/text.js';
import { useReadings } from '../readings.js';
import { call } from '../socket.js';
import { header, state, useSharedState } from '../state.js';

const PERIOD = 250; // ms
const POINTERS = { robot: '$PRO_IP1', submit: '$PRO_IP0' };

/** The abilities of the server of the robot; null until it has answered. */
function useAbilities() {
  const { socket } = useSharedState();
  const connected = header().connection === 'connected';
  const [known, setKnown] = useState(null);
  useEffect(() => {
    let wanted = true;
    if (socket === 'open' && connected) {
      call('programs', { robot: state.robot })
        .then((answer) => wanted && setKnown(answer))
        .catch(() => {}); // the header shows that there is no server
    }
    return () => (wanted = false);
  }, [socket, connected]);
  return known;
}

export function View() {
  useSharedState();
  const known = useAbilities();
  const [interpreter, setInterpreter] = useState('robot');
  const [asked, setAsked] = useState(null);
  const [file, setFile] = useState('');
  const [version, setVersion] = useState(0);
  const pointer = POINTERS[interpreter];
  const [values, stale] = useReadings('programs', [pointer, '$ON_PATH', '$MOVE_BCO'], PERIOD);
  const changed = () => setVersion((old) => old + 1);
  return h(
    'div',
    { class: 'programs' },
    h('h1', { class: 'unseen' }, 'Programs'),
    h(
      'div',
      { class: 'side' },
      h(Interpreters, { known, values, stale, onAsk: setAsked }),
      h(Checks),
    ),
    h(
      'div',
      { class: 'middle' },
      h(ModuleText, {
        known,
        pointer: values[pointer]?.value,
        stale,
        error: values[pointer]?.error,
        interpreter,
        onInterpreter: setInterpreter,
        file,
        onCloseFile: () => setFile(''),
        version,
      }),
      h(Messages, { known, onAsk: setAsked }),
      known?.bridge && h(Files, { onAsk: setAsked, onShow: setFile, version, onChanged: changed }),
    ),
    asked && h(Confirm, { asked, onClose: () => setAsked(null) }),
  );
}
