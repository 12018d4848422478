// The messages of the controller: texts and dialogues of a simulated robot, and their confirmation.

import { h } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { call } from '../socket.js';
import { header, isStale, mayWrite, oldAfter, serverTime, state, useRobot, useSharedState, useStale } from '../state.js';

const PERIOD = 1000; // ms
const KINDS = {
  notification: 'information',
  status: 'state',
  acknowledgement: 'to confirm',
  dialogue: 'question',
};

function useMessages() {
  const { socket } = useSharedState();
  const [answer, setAnswer] = useState(null);
  useEffect(() => {
    if (socket !== 'open') {
      return undefined;
    }
    let wanted = true;
    let timer = 0;
    const ask = async () => {
      if (!document.hidden) {
        try {
          const time = serverTime();
          const messages = await call('messages', { robot: state.robot });
          if (wanted) {
            setAnswer({ ...messages, time });
          }
        } catch {
          // the banner shows a lost connection
        }
      }
      if (wanted) {
        timer = setTimeout(ask, PERIOD);
      }
    };
    ask();
    return () => {
      wanted = false;
      clearTimeout(timer);
    };
  }, [socket]);
  return answer;
}

function Question({ dialogue, onAsk }) {
  const robot = useRobot();
  const answer = (key, label) =>
    onAsk({
      title: `Answer “${label}”?`,
      action: 'Answer',
      facts: [
        ['Question', dialogue.text],
        ['Answer', label],
      ],
      warning: 'The program goes on with this answer.',
      work: async () => {
        await call('answer', { robot, dialogue: dialogue.handle, key, confirmed: true });
        return `answered: ${label}`;
      },
    });
  return h(
    'div',
    { class: 'question', role: 'group', 'aria-label': 'Question of the program' },
    h('p', { class: 'reading' }, dialogue.text),
    h(
      'div',
      { class: 'buttons' },
      dialogue.keys.map(
        (label, i) =>
          label &&
          h('button', { key: i, disabled: !mayWrite(), onClick: () => answer(i + 1, label) }, label),
      ),
    ),
  );
}

/** Shows the messages. */
export function Messages({ known, onAsk }) {
  const robot = useRobot();
  const answer = useMessages();
  const stale = useStale(() => answer?.time, oldAfter(PERIOD));
  const { stop } = header();
  const waits = stop === 'TRUE';
  const unknown = (stop !== 'TRUE' && stop !== 'FALSE') || isStale(header());
  const can = known?.bridge || known?.simulated;
  const confirm = () =>
    onAsk({
      title: 'Confirm all messages?',
      action: 'Confirm',
      facts: [],
      warning: 'Remove their causes first. A program that waits for the confirmation goes on.',
      work: async () => {
        await call('confirm', { robot, confirmed: true });
        return 'The controller has confirmed its messages.';
      },
    });
  return h(
    'section',
    { class: `panel messages ${stale ? 'stale' : ''}`, 'aria-label': 'Messages' },
    h(
      'div',
      { class: 'text-tools' },
      h('h2', null, 'Messages'),
      h(
        'span',
        { class: waits && !unknown ? 'failure' : 'hint', role: 'status' },
        unknown
          ? 'Unknown whether a message waits.'
          : waits
            ? 'A message has to be confirmed.'
            : 'None to confirm.',
      ),
      can && h('button', { disabled: !mayWrite() || !(waits || unknown), onClick: confirm }, 'Confirm all …'),
    ),
    answer?.dialogue && h(Question, { dialogue: answer.dialogue, onAsk }),
    answer?.known === false &&
      h(
        'p',
        { class: 'hint' },
        'No server sends the texts of messages: read them on the pendant. ',
        can || !known ? '' : 'KUKAVARPROXY cannot confirm them either.',
      ),
    answer?.known &&
      h(
        'ol',
        { class: 'message-list' },
        answer.messages.map((one, i) =>
          h(
            'li',
            { key: i, class: one.kind },
            h('span', { class: 'kind' }, KINDS[one.kind] ?? one.kind),
            h('span', { class: 'number' }, one.number || ''),
            h('span', { class: 'message-text reading' }, one.text),
          ),
        ),
      ),
    answer?.known && answer.messages.length === 0 && h('p', { class: 'hint' }, 'There have been none.'),
  );
}
