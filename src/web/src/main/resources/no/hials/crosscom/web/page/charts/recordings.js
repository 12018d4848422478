// The recordings on the computer of the server: start, stop, open, download and delete.

import { h } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { Dialog, useChange } from '../dialog.js';
import { closeReplay, openReplay } from '../replay.js';
import { call, onEvent } from '../socket.js';
import { mayOperate, note, state, useSharedState } from '../state.js';

/** The variables of the 3-D view. */
const POSE = ['$AXIS_ACT', '$POS_ACT', '$BASE', '$TOOL'];

function useRecordings() {
  const [files, setFiles] = useState([]);
  const [running, setRunning] = useState({});
  const { socket } = useSharedState();
  useEffect(() => {
    const ask = () =>
      call('recordings')
        .then((answer) => {
          setFiles(answer.recordings);
          setRunning(Object.fromEntries(answer.running.map((one) => [one.file, one])));
        })
        .catch((e) => note('error', e.message));
    if (socket === 'open') {
      ask();
    }
    const stops = [
      onEvent('recordings', ask),
      onEvent('recording', (one) =>
        setRunning(({ [one.file]: old, ...others }) =>
          one.running ? { ...others, [one.file]: one } : others,
        ),
      ),
      onEvent('recording', (one) => {
        if (!one.running && one.reason !== '') {
          note('error', `The recording ${one.file} has ended: ${one.reason}`);
        }
      }),
    ];
    return () => stops.forEach((stop) => stop());
  }, [socket]);
  return [files, Object.values(running)];
}

function size(bytes) {
  return bytes < 1e6 ? `${Math.max(1, Math.round(bytes / 1e3))} kB` : `${(bytes / 1e6).toFixed(1)} MB`;
}

function Start({ names, period, onClose }) {
  const [name, setName] = useState('');
  const [format, setFormat] = useState('csv');
  const [withPose, setWithPose] = useState(true);
  const { busy, error, close, make } = useChange(onClose);
  const all = [...new Set([...names, ...(withPose ? POSE : [])])];
  const submit = async (event) => {
    event.preventDefault();
    const fields = { robot: state.robot, names: all, period, format };
    const named = name.trim() ? { ...fields, name: name.trim() } : fields;
    if (await make(() => call('record-start', named))) {
      onClose();
    }
  };
  return h(
    Dialog,
    { title: `Record ${state.robot}`, onClose: close },
    h(
      'form',
      { class: 'record-form', onSubmit: submit },
      h(
        'label',
        null,
        'Name',
        h('input', {
          value: name,
          autofocus: true,
          placeholder: 'robot, date and time',
          onInput: (event) => setName(event.target.value),
        }),
      ),
      h(
        'label',
        null,
        'Format',
        h(
          'select',
          { value: format, onChange: (event) => setFormat(event.target.value) },
          h('option', { value: 'csv' }, 'CSV, for spreadsheets'),
          h('option', { value: 'jsonl' }, 'JSON Lines, for programs'),
        ),
      ),
      h(
        'label',
        { class: 'switch' },
        h('input', {
          type: 'checkbox',
          checked: withPose,
          onChange: (event) => setWithPose(event.target.checked),
        }),
        'With the position, for the 3-D view',
      ),
      h('p', { class: 'hint' }, `Every ${period} ms: ${all.join(', ') || 'nothing'}`),
      error && h('p', { class: 'failure', role: 'alert' }, error),
      h(
        'div',
        { class: 'buttons' },
        h('button', { type: 'button', class: 'quiet', onClick: close }, 'Cancel'),
        h('button', { class: 'main', 'aria-disabled': busy, disabled: all.length === 0 }, 'Record'),
      ),
    ),
  );
}

function Delete({ file, onClose }) {
  const remove = async () => {
    onClose();
    try {
      await call('recording-delete', { file });
      if (state.replay?.recording.file === file) {
        closeReplay();
      }
    } catch (e) {
      note('error', e.message);
    }
  };
  return h(
    Dialog,
    { title: `Delete ${file}?`, onClose },
    h('p', null, 'The file is deleted on the computer of the server, for everybody.'),
    h(
      'div',
      { class: 'buttons' },
      h('button', { class: 'quiet', autofocus: true, onClick: onClose }, 'Cancel'),
      h('button', { class: 'main', onClick: remove }, 'Delete'),
    ),
  );
}

function Running({ one }) {
  const [busy, setBusy] = useState(false);
  const stop = async () => {
    setBusy(true);
    try {
      const end = await call('record-stop', { file: one.file });
      note('done', `${end.file}: ${end.rows} rows in ${end.seconds.toFixed(1)} s`);
    } catch (e) {
      note('error', e.message);
    }
    setBusy(false);
  };
  return h(
    'li',
    { class: `running ${one.lost ? 'lost' : ''}` },
    h('span', { class: 'dot', 'aria-hidden': 'true' }, '●'),
    h('span', { class: 'file' }, one.file),
    h(
      'span',
      { class: 'state' },
      one.lost ? 'connection lost, ' : '',
      `${one.seconds.toFixed(1)} s, ${one.rows} rows`,
      one.missed > 0 ? `, ${one.missed} periods missed` : '',
    ),
    mayOperate() &&
      h(
        'button',
        { class: 'main', disabled: busy, 'aria-label': `Stop ${one.file}`, onClick: stop },
        'Stop',
      ),
  );
}

/** Records some variables, and lists the recordings. */
export function Recordings({ names, period }) {
  const [files, running] = useRecordings();
  const [dialog, setDialog] = useState(null);
  const [opening, setOpening] = useState('');
  const open = async (file) => {
    setOpening(file);
    try {
      await openReplay(file);
    } catch (e) {
      note('error', e.message);
    }
    setOpening('');
  };
  const close = () => setDialog(null);
  const isRunning = (file) => running.some((one) => one.file === file);
  return h(
    'section',
    { class: 'panel recordings', 'aria-label': 'Recordings' },
    h(
      'div',
      { class: 'title' },
      h('h2', null, 'Recordings'),
      mayOperate() &&
        h('button', { class: 'record', onClick: () => setDialog('start') }, '● Record …'),
    ),
    h(
      'ul',
      null,
      running.map((one) => h(Running, { key: one.file, one })),
      files
        .filter(({ file }) => !isRunning(file))
        .map(({ file, bytes, modified }) =>
          h(
            'li',
            { key: file },
            h('span', { class: 'file' }, file),
            h('span', { class: 'state' }, `${new Date(modified).toLocaleString()}, ${size(bytes)}`),
            h(
              'span',
              { class: 'buttons' },
              h(
                'button',
                {
                  'aria-label': `Open ${file}`,
                  disabled: opening !== '' || state.replay?.recording.file === file,
                  onClick: () => open(file),
                },
                opening === file ? 'Opening …' : 'Open',
              ),
              h(
                'a',
                {
                  class: 'button',
                  href: `/recordings/${file}`,
                  download: file,
                  'aria-label': `Download ${file}`,
                },
                'Download',
              ),
              mayOperate() &&
                h(
                  'button',
                  {
                    class: 'quiet',
                    'aria-label': `Delete ${file}`,
                    onClick: () => setDialog(file),
                  },
                  'Delete',
                ),
            ),
          ),
        ),
    ),
    files.length + running.length === 0 && h('p', { class: 'hint' }, 'There are none yet.'),
    dialog === 'start' && h(Start, { names, period, onClose: close }),
    dialog !== null && dialog !== 'start' && h(Delete, { file: dialog, onClose: close }),
  );
}
