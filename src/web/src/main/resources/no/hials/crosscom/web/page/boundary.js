// Limits a failure to its view: the header, which shows the state of the robot, stays.

import { Component, h } from 'preact';

export class Boundary extends Component {
  constructor() {
    super();
    this.state = { error: null };
  }

  componentDidCatch(error) {
    this.setState({ error });
  }

  render({ children }, { error }) {
    if (error === null) {
      return children;
    }
    return h(
      'section',
      { class: 'panel', role: 'alert' },
      h('p', { class: 'failure' }, `This view has failed: ${error.message}. Nothing in it is up to date.`),
      h('button', { onClick: () => this.setState({ error: null }) }, 'Show it again'),
    );
  }
}
