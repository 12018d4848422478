// The colours of the page as a canvas needs them, and those of the lines.

import { useEffect } from 'preact/hooks';

export const LINES = 10;
const known = new Map();

/** Returns a colour of the style sheets, such as --line. */
export function colour(name) {
  if (!known.has(name)) {
    const probe = document.createElement('i');
    probe.style.color = `var(${name})`;
    document.body.append(probe);
    known.set(name, getComputedStyle(probe).color);
    probe.remove();
  }
  return known.get(name);
}

/** Returns the name of the colour of a line. */
export function lineColour(index) {
  return `--line-${index % LINES}`;
}

/** Calls a function when the colours have changed between light and dark. */
export function useColours(listener) {
  useEffect(() => {
    const dark = matchMedia('(prefers-color-scheme: dark)');
    const again = () => {
      known.clear();
      listener();
    };
    known.clear(); // the colours may have changed in another view
    const observer = new MutationObserver(again);
    observer.observe(document.documentElement, { attributeFilter: ['data-theme'] });
    dark.addEventListener('change', again);
    return () => {
      observer.disconnect();
      dark.removeEventListener('change', again);
    };
  }, []);
}
