import { attributeArray, Fn, instanceIndex, int, ivec2, screenCoordinate, textureLoad } from 'three/tsl';
import {
  DataTexture,
  FloatType,
  NearestFilter,
  NodeMaterial,
  QuadMesh,
  RenderTarget,
  RGBAFormat,
  type WebGPURenderer,
} from 'three/webgpu';
import type { Twin, TwinCase } from '../../../src/shaders/twins/twin.ts';
import type { Int, Vec4 } from '../../../src/shaders/types.ts';

/** Width of the input texture and of the output target. */
const WIDTH = 256;

/** Runs the twin on a GPU. Returns 4 numbers per output, case by case. Rejects if a canary is not returned. */
export type Runner = (renderer: WebGPURenderer, twin: Twin, cases: readonly TwinCase[]) => Promise<Float32Array>;

/** On WebGPU: a compute shader from buffer to buffer. (Constants would be folded by the compiler on the CPU.) */
export const computeTwin: Runner = async (renderer, twin, cases) => {
  const stride = twin.texels + 1;
  const rows = twin.outputs + 1;
  const { data, canaries } = pack(twin, cases);
  const input = attributeArray(data, 'vec4');
  const output = attributeArray(new Float32Array(cases.length * rows * 4), 'vec4');
  const kernel = Fn(() => {
    const first = int(instanceIndex).mul(stride).toVar();
    const texel = (index: number | Int) => input.element(first.add(index)).toVar();
    const results = [...twin.gpu(texel), canaryAnswer(texel(twin.texels))];
    for (const [k, result] of results.entries()) output.element(int(instanceIndex).mul(rows).add(k)).assign(result);
  })().compute(cases.length);
  renderer.compute(kernel);
  const values = new Float32Array(await renderer.getArrayBufferAsync(output.value));
  return unpack(twin, cases.length, canaries, (i, k) => values.subarray(4 * (i * rows + k), 4 * (i * rows + k) + 4));
};

/** On WebGL2: fragments of a float target, one per case, reading inputs from a float texture. One pass per output. */
export const renderTwin: Runner = async (renderer, twin, cases) => {
  const { data, canaries } = pack(twin, cases);
  const texture = floatTexture(data);
  const height = Math.ceil(cases.length / WIDTH);
  const target = new RenderTarget(WIDTH, height, { type: FloatType, depthBuffer: false });
  target.texture.minFilter = target.texture.magFilter = NearestFilter;
  const passes: ArrayLike<number>[] = [];
  for (let k = 0; k <= twin.outputs; k++) {
    renderer.setRenderTarget(target);
    new QuadMesh(passMaterial(twin, texture, k)).render(renderer);
    passes.push(await renderer.readRenderTargetPixelsAsync(target, 0, 0, WIDTH, height));
  }
  renderer.setRenderTarget(null);
  target.dispose();
  texture.dispose();
  return unpack(twin, cases.length, canaries, (i, k) => {
    // WebGL reads the lowest row first; screenCoordinate counts from the top.
    const at = 4 * ((height - 1 - Math.floor(i / WIDTH)) * WIDTH + (i % WIDTH));
    return [0, 1, 2, 3].map((c) => passes[k][at + c]);
  });
};

function passMaterial(twin: Twin, texture: DataTexture, k: number): NodeMaterial {
  const material = new NodeMaterial();
  material.fragmentNode = Fn(() => {
    const pixel = ivec2(screenCoordinate.xy);
    const first = pixel.y
      .mul(WIDTH)
      .add(pixel.x)
      .mul(twin.texels + 1)
      .toVar();
    const texel = (index: number | Int): Vec4 => {
      const at = first.add(index).toVar();
      return textureLoad(texture, ivec2(at.bitAnd(int(WIDTH - 1)), at.div(WIDTH))).toVar();
    };
    return k < twin.outputs ? twin.gpu(texel)[k] : canaryAnswer(texel(twin.texels));
  })();
  return material;
}

function floatTexture(data: Float32Array): DataTexture {
  const height = Math.ceil(data.length / 4 / WIDTH);
  const padded = new Float32Array(WIDTH * height * 4);
  padded.set(data);
  const texture = new DataTexture(padded, WIDTH, height, RGBAFormat, FloatType);
  texture.needsUpdate = true;
  return texture;
}

/** The expected result for a canary: something that no copy, clear or stale buffer yields. */
const canaryAnswer = (canary: Vec4): Vec4 => canary.wzyx.mul(2).add(1);

function pack(twin: Twin, cases: readonly TwinCase[]): { data: Float32Array<ArrayBuffer>; canaries: Float32Array } {
  const stride = 4 * (twin.texels + 1);
  const data = new Float32Array(stride * cases.length);
  // Not seeded, so that results left over from another run cannot pass. Integers, so that the result is exact.
  const canaries = Float32Array.from({ length: 4 * cases.length }, () => Math.floor(Math.random() * 1e6));
  cases.forEach(({ input }, i) => {
    if (input.length !== 4 * twin.texels) throw new Error(`${twin.name}: a case has ${input.length} numbers`);
    data.set(input, i * stride);
    data.set(canaries.subarray(4 * i, 4 * i + 4), i * stride + 4 * twin.texels);
  });
  return { data, canaries };
}

function unpack(
  twin: Twin,
  count: number,
  canaries: Float32Array,
  read: (index: number, output: number) => ArrayLike<number>,
): Float32Array {
  const values = new Float32Array(count * twin.outputs * 4);
  for (let i = 0; i < count; i++) {
    const answer = read(i, twin.outputs);
    for (let c = 0; c < 4; c++)
      if (answer[c] !== 2 * canaries[4 * i + 3 - c] + 1)
        throw new Error(
          `${twin.name}: the canary of case ${i} came back as ${answer[c]}, sent ${canaries[4 * i + 3 - c]}`,
        );
    for (let k = 0; k < twin.outputs; k++) values.set(Array.from(read(i, k)), 4 * (i * twin.outputs + k));
  }
  return values;
}
