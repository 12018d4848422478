// The shape of a link from an STL file, binary or text. The loader takes nearly anything; what is wrong
// with a file is found here.

import { STLLoader } from 'three/stl-loader';

const HEADER = 84; // bytes of a binary file, with the number of triangles at the end
const TRIANGLE = 50; // bytes
const FARTHEST = 100_000; // mm from the origin; the picture has no place for more

/** Returns the contents of a file so that the loader knows which of both kinds it is. */
function contents(data) {
  const size = data.byteLength;
  const count = size < HEADER ? 0 : new DataView(data).getUint32(HEADER - 4, true);
  const needed = HEADER + TRIANGLE * count;
  if (size === needed) {
    return data;
  }
  const text = new TextDecoder().decode(data).trimStart();
  if (/^solid/i.test(text)) {
    // the loader looks for words in small letters, and reads as many bytes as a binary header has
    return text.toLowerCase().padEnd(HEADER);
  }
  throw new Error(
    size < HEADER
      ? `it has ${size} bytes and does not begin with solid, unlike an STL file`
      : `it does not begin with solid, and as a binary file of ${count} triangles it must have ${needed} bytes, has ${size}`,
  );
}

/**
 * Returns the geometry of an STL file.
 *
 * @throws Error with the reason if it cannot be shown
 */
export function readShape(data) {
  const geometry = new STLLoader().parse(contents(data));
  const position = geometry.getAttribute('position');
  if (position.count === 0) {
    throw new Error('it has no complete triangle');
  }
  if (position.count % 3 !== 0) {
    throw new Error('a triangle must have three vertices of three numbers each');
  }
  const { array } = position;
  const wrong = array.findIndex((one) => !(Math.abs(one) <= FARTHEST));
  if (wrong >= 0) {
    const first = wrong - (wrong % 3);
    throw new Error(
      `a vertex must be within ${FARTHEST / 1000} m, is at ${array.slice(first, first + 3).join(', ')} mm`,
    );
  }
  return geometry;
}
