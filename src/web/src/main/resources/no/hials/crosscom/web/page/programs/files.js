// The programs on the controller: folders, the selection of a program, and the upload of a file.

import { h } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { call } from '../socket.js';
import { mayWrite, note, state, useRobot } from '../state.js';

const ROOT = 'KRC:\\R1';
const MAX_BYTES = 180 * 1024;

function useFolder(version) {
  const [folder, setFolder] = useState(`${ROOT}\\Program`);
  const [items, setItems] = useState([]);
  useEffect(() => {
    let wanted = true;
    call('program-files', { robot: state.robot, folder })
      .then((answer) => wanted && setItems(answer.items))
      .catch((e) => {
        if (wanted) {
          setItems([]);
          note('error', e.message);
        }
      });
    return () => (wanted = false);
  }, [folder, version, state.socket]);
  return [folder, setFolder, items];
}

/** Returns the content of a file in Base64. */
function base64(file) {
  return new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.onload = () => resolve(reader.result.slice(reader.result.indexOf(',') + 1));
    reader.onerror = () => reject(new Error(`${file.name} cannot be read`));
    reader.readAsDataURL(file);
  });
}

/** Checks a file, and returns the question before its upload. */
async function uploadQuestion(robot, file, folder, onDone) {
  if (file.size > MAX_BYTES) {
    throw new Error(`${file.name} has ${file.size} bytes; the page uploads at most ${MAX_BYTES}. Use 'jopenshowvar file put'.`);
  }
  const fields = { robot, folder, name: file.name, content: await base64(file) };
  const found = await call('upload-check', fields);
  return {
    title: found.exists ? `Replace ${file.name}?` : `Upload ${file.name}?`,
    action: found.exists ? 'Replace' : 'Upload',
    facts: [
      ['File', found.path],
      ['Size', `${found.size} bytes`],
    ],
    warning: found.exists ? 'A file of this name exists. Its content will be lost.' : '',
    details:
      found.errors > 0 &&
      h(
        'div',
        null,
        h('p', { class: 'failure' }, `${found.errors} errors, with which a controller does not select it:`),
        h('ul', { class: 'errors' }, found.first.map((one) => h('li', { key: one, class: 'variable' }, one))),
      ),
    work: async () => {
      const stored = await call('upload', { ...fields, overwrite: found.exists, confirmed: true });
      onDone();
      return `${stored.path}: stored, read back and compared, ${stored.size} bytes`;
    },
  };
}

function Item({ item, onOpen, onShow, onSelect }) {
  const isProgram = item.name.toLowerCase().endsWith('.src');
  return h(
    'li',
    null,
    h(
      'button',
      { class: 'name quiet', onClick: () => (item.folder ? onOpen(item.path) : onShow(item.path)) },
      item.folder ? `${item.name}\\` : item.name,
    ),
    h('span', { class: 'hint' }, item.folder || item.size === undefined ? '' : `${item.size} bytes`),
    isProgram &&
      h(
        'button',
        { disabled: !mayWrite(), 'aria-label': `Select ${item.name}`, onClick: () => onSelect(item) },
        'Select …',
      ),
  );
}

/** Shows the files of a folder. */
export function Files({ onAsk, onShow, version, onChanged }) {
  const robot = useRobot();
  const [folder, setFolder, items] = useFolder(version);
  const parent = folder.slice(0, folder.lastIndexOf('\\'));
  const select = (item) =>
    onAsk({
      title: `Select ${item.name}?`,
      action: 'Select',
      facts: [['Program', item.path]],
      warning: 'The robot does not move yet. Another selected program loses its place.',
      work: async () => {
        await call('program-select', { robot, name: item.path, confirmed: true });
        onChanged();
        return `${item.name} is selected`;
      },
    });
  const upload = async (event) => {
    const [file] = event.target.files;
    event.target.value = '';
    if (file) {
      try {
        onAsk(await uploadQuestion(robot, file, folder, onChanged));
      } catch (e) {
        note('error', e.message);
      }
    }
  };
  return h(
    'section',
    { class: 'panel files', 'aria-label': 'Files of the controller' },
    h(
      'div',
      { class: 'text-tools' },
      h('h2', { class: 'variable' }, folder),
      folder !== ROOT && h('button', { onClick: () => setFolder(parent) }, 'Up'),
      h('button', { onClick: onChanged }, 'Read again'),
      mayWrite() &&
        h(
          'label',
          { class: 'button' },
          'Upload …',
          h('input', {
            type: 'file',
            accept: '.src,.sub,.dat,.SRC,.SUB,.DAT',
            'aria-label': `Upload a file into ${folder}`,
            onChange: upload,
          }),
        ),
    ),
    h(
      'ul',
      { class: 'file-list' },
      items.map((item) => h(Item, { key: item.path, item, onOpen: setFolder, onShow, onSelect: select })),
    ),
    items.length === 0 && h('p', { class: 'hint' }, 'This folder has no folders and no files of KRL.'),
  );
}
