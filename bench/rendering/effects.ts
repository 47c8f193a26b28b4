import { pumpFrame } from '../../src/cli/gpu/nodeShim.ts';
import { random } from '../../src/math/random.ts';
import type { EffectId } from '../../src/scene/frameGraph/effects.ts';
import type { ShaderProgram } from '../../src/scene/shaderText/program.ts';
import { readShaderText } from '../../src/scene/shaderText/shaderText.ts';
import type { Bench } from '../support/bench.ts';
import { interleaved } from '../support/bench.ts';
import { gpu } from '../support/gpu.ts';

const SIZE = { width: 640, height: 360 };
const SIGMA = 4;
const ROUNDS = 9;

export const effects: Bench = {
  name: 'effects',
  title: 'Effects over a picture, against hand-written shaders',
  about:
    `A chain over a picture of ${SIZE.width} × ${SIZE.height} in halves: a Gaussian of σ = ${SIGMA} px across and one down, a vignette, and the picture added. ` +
    '*By hand* are four WGSL shaders on the bare device, of the same arithmetic, with their loops and edges written for these two directions. *Text* is the same chain with both blurs and ' +
    'the vignette as somebody would write them for the node. They take turns; a round ends when the GPU is done.',
  async run() {
    const { adapterName } = await gpu();
    const chains = [await byHand(), await ours(), await text()];
    const [hand, library, written] = await interleaved(
      chains.map(({ draw }) => draw),
      ROUNDS,
    );
    for (const { dispose } of chains) dispose();
    return [
      {
        columns: ['by hand [ms]', 'effects [ms]', 'text [ms]', 'effects ÷ by hand', 'text ÷ by hand'],
        rows: [[hand, library, written, library / hand, written / hand]],
        remark: `On ${adapterName}.`,
      },
    ];
  },
};

interface Chain {
  draw(): Promise<void>;
  dispose(): void;
}

function noise(): Float32Array<ArrayBuffer> {
  const next = random(3);
  return Float32Array.from({ length: 4 * SIZE.width * SIZE.height }, () => 4 * next());
}

/** three's passes, ping-ponging between two targets. */
async function chainOf(steps: readonly (readonly [EffectId | ShaderProgram, readonly number[]])[]): Promise<Chain> {
  const { device } = await gpu();
  const { DataTexture, FloatType, HalfFloatType, RGBAFormat } = await import('three/webgpu');
  const { openGpu } = await import('../../src/render/gpu/device.ts');
  const { EffectPasses } = await import('../../src/render/post/effectPasses.ts');
  const { dataTarget } = await import('../../src/render/gbuffer/gbuffer.ts');
  const { makeFrameUniforms } = await import('../../src/render/gpu/frameUniforms.ts');
  const { renderer } = await openGpu({ device });
  const uniforms = makeFrameUniforms();
  const { width, height } = SIZE;
  const picture = new DataTexture(noise(), width, height, RGBAFormat, FloatType);
  picture.needsUpdate = true;
  const targets = Array.from({ length: steps.length + 1 }, () => dataTarget(1, HalfFloatType));
  for (const target of targets) target.setSize(width, height);
  const before = (i: number) => targets[i - 1]?.texture ?? picture;
  const passes = steps.map(([of], i) =>
    EffectPasses.forEffect(of, { image: before(i), uniforms, type: HalfFloatType }),
  );
  const added = { image: before(steps.length), uniforms, type: HalfFloatType };
  const last = EffectPasses.forMix('add', picture, added);
  return {
    draw: async () => {
      pumpFrame();
      for (const [i, [, args]] of steps.entries()) passes[i].render(renderer, targets[i], { args });
      last.render(renderer, targets[steps.length], { args: [0.5] });
      await device.queue.onSubmittedWorkDone();
    },
    dispose: () => {
      for (const pass of [...passes, last]) pass.dispose();
      for (const target of targets) target.dispose();
      renderer.dispose();
    },
  };
}

const ours = (): Promise<Chain> =>
  chainOf([
    ['gaussian-blur', [SIGMA, 0]],
    ['gaussian-blur', [SIGMA, 90]],
    ['vignette', [1, 4, 0]],
  ]);

function text(): Promise<Chain> {
  const blur = (offset: string) => `
fn effect(p: Pixel) -> vec4f {
  var sum = vec4f(0);
  var total = 0.0;
  for (var k = -${3 * SIGMA}; k <= ${3 * SIGMA}; k++) {
    let w = exp(-0.5 * f32(k * k) / (arg1 * arg1));
    sum += w * image(${offset});
    total += w;
  }
  return sum / total;
}`;
  const vignette = `
fn effect(p: Pixel) -> vec4f {
  let t = (p.uv * 2 - 1) * vec2f(1, p.size.y / p.size.x);
  return vec4f(p.color.rgb * pow(1 + dot(t, t), -2), p.color.a);
}`;
  return chainOf([
    [readShaderText(blur('vec2i(k, 0)')), [SIGMA]],
    [readShaderText(blur('vec2i(0, k)')), [SIGMA]],
    [readShaderText(vignette), []],
  ]);
}

const WGSL = `
@group(0) @binding(0) var image: texture_2d<f32>;
@group(0) @binding(1) var over: texture_2d<f32>;
@vertex fn corner(@builtin(vertex_index) i: u32) -> @builtin(position) vec4f {
  return vec4f(f32(i & 1u) * 4 - 1, f32(i >> 1u) * 4 - 1, 0, 1);
}
fn at(p: vec2i) -> vec4f {
  let n = vec2i(textureDimensions(image));
  let once = max(p, -1 - p);
  return textureLoad(image, clamp(min(once, 2 * n - 1 - once), vec2i(0), n - 1), 0);
}
fn blurred(p: vec2i, step: vec2i) -> vec4f {
  var sum = vec4f(0);
  var total = 0.0;
  for (var k = -${3 * SIGMA}; k <= ${3 * SIGMA}; k++) {
    let w = exp(-0.5 * f32(k * k) / ${SIGMA ** 2}.0);
    sum += w * at(p + k * step);
    total += w;
  }
  return sum / total;
}
@fragment fn across(@builtin(position) p: vec4f) -> @location(0) vec4f { return blurred(vec2i(p.xy), vec2i(1, 0)); }
@fragment fn down(@builtin(position) p: vec4f) -> @location(0) vec4f { return blurred(vec2i(p.xy), vec2i(0, 1)); }
@fragment fn vignette(@builtin(position) p: vec4f) -> @location(0) vec4f {
  let n = vec2f(textureDimensions(image));
  let t = (p.xy / n * 2 - 1) * vec2f(1, n.y / n.x);
  let c = textureLoad(image, vec2i(p.xy), 0);
  return vec4f(c.rgb * pow(1 + dot(t, t), -2), c.a);
}
@fragment fn added(@builtin(position) p: vec4f) -> @location(0) vec4f {
  let c = textureLoad(image, vec2i(p.xy), 0);
  return vec4f(c.rgb + 0.5 * textureLoad(over, vec2i(p.xy), 0).rgb, c.a);
}`;

async function byHand(): Promise<Chain> {
  const { device } = await gpu();
  const { width, height } = SIZE;
  const module = device.createShaderModule({ code: WGSL });
  // TEXTURE_BINDING, COPY_DST and RENDER_ATTACHMENT.
  const texture = (format: GPUTextureFormat) =>
    device.createTexture({ size: [width, height], format, usage: 4 | 2 | 16 });
  const picture = texture('rgba32float');
  device.queue.writeTexture({ texture: picture }, noise(), { bytesPerRow: 16 * width }, [width, height]);
  const names = ['across', 'down', 'vignette', 'added'];
  const targets = names.map(() => texture('rgba16float'));
  // FRAGMENT; float textures are read unfiltered.
  const entry = (binding: number): GPUBindGroupLayoutEntry => ({
    binding,
    visibility: 2,
    texture: { sampleType: 'unfilterable-float' },
  });
  const bindings = device.createBindGroupLayout({ entries: [entry(0), entry(1)] });
  const layout = device.createPipelineLayout({ bindGroupLayouts: [bindings] });
  const pipelines = names.map((entryPoint) =>
    device.createRenderPipeline({
      layout,
      vertex: { module, entryPoint: 'corner' },
      fragment: { module, entryPoint, targets: [{ format: 'rgba16float' }] },
    }),
  );
  const groups = names.map((_, i) => {
    const from = targets[i - 1] ?? picture;
    const resources = [from, picture].map((of, binding) => ({ binding, resource: of.createView() }));
    return device.createBindGroup({ layout: bindings, entries: resources });
  });
  const draw = async (): Promise<void> => {
    const commands = device.createCommandEncoder();
    names.forEach((_, i) => {
      const view = targets[i].createView();
      const pass = commands.beginRenderPass({ colorAttachments: [{ view, loadOp: 'clear', storeOp: 'store' }] });
      pass.setPipeline(pipelines[i]);
      pass.setBindGroup(0, groups[i]);
      pass.draw(3);
      pass.end();
    });
    device.queue.submit([commands.finish()]);
    await device.queue.onSubmittedWorkDone();
  };
  return {
    draw,
    dispose: () => {
      for (const one of [...targets, picture]) one.destroy();
    },
  };
}
