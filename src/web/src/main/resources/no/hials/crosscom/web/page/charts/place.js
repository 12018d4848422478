// The place of a panel in the page: its size, and whether it can be seen.

export class Place {
  isVisible = true;

  /**
   * @param element the place
   * @param resize called with each new width and height
   */
  constructor(element, resize) {
    this.resized = new ResizeObserver(() => {
      const { clientWidth, clientHeight } = element;
      if (clientWidth > 0 && clientHeight > 0) {
        resize(clientWidth, clientHeight);
      }
    });
    this.resized.observe(element);
    this.watched = new IntersectionObserver(([entry]) => {
      this.isVisible = entry.isIntersecting;
    });
    this.watched.observe(element);
  }

  dispose() {
    this.resized.disconnect();
    this.watched.disconnect();
  }
}
