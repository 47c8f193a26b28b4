import type { BufferGeometry } from 'three/webgpu';

/** Geometries that several owners draw, and their attributes and indices. */
const shared = new WeakSet<object>();

/** Marks a geometry that several owners draw, and whose vertices their own geometries may have too: no one changes it, and `disposeGeometry` leaves it alone. */
export function shareGeometry<T extends BufferGeometry>(geometry: T): T {
  for (const owned of [geometry, geometry.index, ...Object.values(geometry.attributes)]) if (owned) shared.add(owned);
  return geometry;
}

/** Gives `to` the vertex attributes of `from`: they are on the GPU once. */
export function shareVertices<T extends BufferGeometry>(from: BufferGeometry, to: T): T {
  for (const [name, attribute] of Object.entries(from.attributes)) to.setAttribute(name, attribute);
  return to;
}

/**
 * Frees the GPU memory of a geometry that is not needed any more, but for what it shares. Dispose of its materials first: three.js frees all attributes of
 * a disposed geometry and of what is still drawn with it (0.187).
 */
export function disposeGeometry(geometry: BufferGeometry): void {
  if (shared.has(geometry)) return;
  for (const [name, attribute] of Object.entries(geometry.attributes))
    if (shared.has(attribute)) geometry.deleteAttribute(name);
  if (geometry.index && shared.has(geometry.index)) geometry.setIndex(null);
  geometry.dispose();
}
