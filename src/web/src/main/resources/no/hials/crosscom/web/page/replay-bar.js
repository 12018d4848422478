// The bar of the player, on top of every view while a recording is open.

import { h } from 'preact';
import { closeReplay, SPEEDS, usePlayerTime } from './replay.js';
import { changed, useSharedState } from './state.js';

export function ReplayBar() {
  const player = useSharedState().replay;
  usePlayerTime(player);
  if (!player) {
    return null;
  }
  const seconds = (time) => time.toFixed(1);
  return h(
    'section',
    { class: 'replay', 'aria-label': 'Replay' },
    h(
      'p',
      { class: 'what' },
      h('strong', null, 'Recording'),
      ' ',
      h('span', { class: 'file' }, player.recording.file),
    ),
    h(
      'button',
      { class: 'main', onClick: () => (player.playing ? player.pause() : player.play()) },
      player.playing ? 'Pause' : 'Play',
    ),
    h('input', {
      type: 'range',
      min: 0,
      max: player.end,
      step: 'any',
      value: player.time,
      'aria-label': 'Time of the replay',
      'aria-valuetext': `${seconds(player.time)} of ${seconds(player.end)} seconds`,
      onInput: (event) => player.seek(Number(event.target.value)),
    }),
    h('span', { class: 'time' }, `${seconds(player.time)} / ${seconds(player.end)} s`),
    h(
      'select',
      {
        'aria-label': 'Speed of the replay',
        value: player.speed,
        onChange: (event) => {
          player.speed = Number(event.target.value);
          changed();
        },
      },
      SPEEDS.map((speed) => h('option', { key: speed, value: speed }, `${speed} ×`)),
    ),
    h('button', { onClick: closeReplay }, 'Close'),
  );
}
