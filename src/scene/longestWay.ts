/** The vertex that goes farthest from one sample to the next, and how far [m]; vertex 0 where all rest. */
export function longestWay(a: Float32Array, b: Float32Array): { readonly way: number; readonly vertex: number } {
  let square = 0;
  let vertex = 0;
  for (let i = 0; i < a.length; i += 3) {
    const x = b[i] - a[i];
    const y = b[i + 1] - a[i + 1];
    const z = b[i + 2] - a[i + 2];
    const s = x * x + y * y + z * z;
    if (s > square && s < Number.POSITIVE_INFINITY) {
      square = s;
      vertex = i / 3;
    }
  }
  return { way: Math.sqrt(square), vertex };
}
