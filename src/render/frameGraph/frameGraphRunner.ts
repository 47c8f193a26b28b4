import { Fn, uniform, vec3, vec4 } from 'three/tsl';
import type { RenderTarget } from 'three/webgpu';
import type { FrameGraph, FrameGraphPass } from '../../scene/frameGraph/frameGraph.ts';
import { toneMaps } from '../../shaders/color/toneMap.ts';
import type { BufferLight, DeferredPass } from '../deferredPass.ts';
import { dataTarget } from '../gbuffer/gbuffer.ts';
import type { Gpu } from '../gpu/device.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import { FullScreenPass, texelHere } from '../gpu/fullScreenPass.ts';
import { IMAGE_RANGE } from '../gpu/lightRange.ts';
import type { GBufferView } from '../opaqueGeometry.ts';
import type { PictureSample } from '../pictureSample.ts';
import { decodeSrgb } from '../post/display/display.ts';
import { FalseColorTable, falseColored } from '../post/display/falseColor.ts';
import { EffectPasses, type EffectValues, type PassInputs } from '../post/effectPasses.ts';
import { StillImage } from './stillImage.ts';
import { allocateTargets, linearSourceOf } from './targetAllocation.ts';

/** Called with the index and the image of a pass after it has run. */
export type PassListener = (pass: number, image: RenderTarget) => void;

/** Runs one pass of a frame graph, other than light and stills. */
interface PassRunner {
  /** `pass` may differ in its numbers from the one that the runner was made for, but not in its structure. */
  run(pass: FrameGraphPass, time: number): void;
  setSize?(width: number, height: number): void;
  dispose(): void;
}

/** Runs frame graphs of one structure. Its shaders are built once; numbers are uniforms. Images that are not needed at the same time share a target. */
export class FrameGraphRunner {
  private readonly gpu: Gpu;
  private readonly uniforms: FrameUniforms;
  private readonly deferredPass: (buffer: number) => DeferredPass;
  private readonly pool: readonly RenderTarget[];
  /** By pass; undefined except for stills. */
  private readonly stills: readonly (StillImage | undefined)[];
  /** By pass: the target with its image; that of a light belongs to its `DeferredPass`. */
  private readonly targets: readonly RenderTarget[];
  /** By pass; undefined for light and stills. */
  private readonly passRunners: readonly (PassRunner | undefined)[];
  /** By pass, for lights: the index among the lights of its G-buffer. */
  private readonly lightIndices: readonly number[];

  constructor(
    { passes }: FrameGraph,
    gpu: Gpu,
    uniforms: FrameUniforms,
    deferredPass: (buffer: number) => DeferredPass,
  ) {
    this.gpu = gpu;
    this.uniforms = uniforms;
    this.deferredPass = deferredPass;
    const { slots, count } = allocateTargets(passes);
    this.pool = Array.from({ length: count }, () => dataTarget(1, IMAGE_RANGE.type));
    this.lightIndices = passes.map(
      (pass, i) => passes.slice(0, i).filter((other) => isLightOfSameBuffer(other, pass)).length,
    );
    this.stills = passes.map((pass) => (pass.kind === 'still' ? new StillImage(pass.still) : undefined));
    this.targets = passes.map((pass, i) =>
      pass.kind === 'light'
        ? deferredPass(pass.buffer).light(this.lightIndices[i])
        : (this.stills[i]?.target ?? this.pool[slots[i]]),
    );
    this.passRunners = passes.map((pass, i) => this.makeRunner(pass, i, passes));
  }

  setSize(width: number, height: number): void {
    for (const target of this.pool) target.setSize(width, height);
    for (const sized of [...this.passRunners, ...this.stills]) sized?.setSize?.(width, height);
  }

  /** Draws the stills that have changed. Call it before `draw` is passed to `precompile`, which draws nothing. */
  updateStills({ passes }: Pick<FrameGraph, 'passes'>): void {
    passes.forEach((pass, i) => {
      if (pass.kind === 'still') this.stills[i]?.update(this.gpu.renderer, pass.still);
    });
  }

  /** The lights that a frame graph needs before `draw`. */
  lights({ passes }: FrameGraph, { views }: Pick<PictureSample, 'views'>): readonly BufferLight[] {
    return passes.flatMap((pass, i) =>
      pass.kind === 'light' ? [lightOf(pass, this.lightIndices[i], views[pass.buffer].view)] : [],
    );
  }

  /** Draws all but the lights of one sample, while its first G-buffer is bound, and returns its target. `onPass` is called after each pass; later passes may overwrite its image. */
  draw(
    { passes }: FrameGraph,
    { views, time }: Pick<PictureSample, 'views' | 'time'>,
    onPass?: PassListener,
  ): RenderTarget {
    this.updateStills({ passes });
    let boundBuffer = 0;
    const bindBuffer = (buffer: number): void => {
      if (buffer !== boundBuffer) views[buffer].bind();
      boundBuffer = buffer;
    };
    passes.forEach((pass, i) => {
      if ('buffer' in pass) bindBuffer(pass.buffer);
      this.passRunners[i]?.run(pass, time);
      onPass?.(i, this.targets[i]);
    });
    bindBuffer(0);
    return this.targets[passes.length - 1];
  }

  dispose(): void {
    for (const owned of [...this.passRunners, ...this.stills]) owned?.dispose();
    for (const target of this.pool) target.dispose();
  }

  private makeRunner(pass: FrameGraphPass, i: number, passes: readonly FrameGraphPass[]): PassRunner | undefined {
    switch (pass.kind) {
      case 'light':
      case 'still':
        return undefined;
      case 'occlusion':
        return this.occlusion(pass, i);
      case 'effect':
        return this.effect(pass, i);
      case 'mix':
        return this.mix(pass, i);
      case 'tone':
        return this.toneMap(pass, i);
      case 'false-colour':
        return this.falseColor(pass, i, passes);
    }
  }

  private texture = (image: number) => this.targets[image].texture;

  private inputs(image: number, mask?: number, buffer?: number): PassInputs {
    return {
      image: this.texture(image),
      uniforms: this.uniforms,
      type: IMAGE_RANGE.type,
      ...(mask !== undefined && { mask: this.texture(mask) }),
      ...(buffer !== undefined && { buffer: this.deferredPass(buffer).buffer }),
    };
  }

  private occlusion({ buffer }: Of<'occlusion'>, i: number): PassRunner {
    const deferredPass = this.deferredPass(buffer);
    const { renderer } = this.gpu;
    const gray = new FullScreenPass(vec4(vec3(texelHere(deferredPass.opennessTexture).x), 1), 'occlusion');
    return {
      run: (pass) => {
        if (pass.kind !== 'occlusion') return;
        deferredPass.openness(pass.radius === 0 ? undefined : pass.radius);
        gray.render(renderer, this.targets[i]);
      },
      dispose: () => gray.dispose(),
    };
  }

  private effect({ effect, image, second, buffer, mask }: Of<'effect'>, i: number): PassRunner {
    const source = typeof effect === 'string' ? effect : effect.program;
    const inputs = this.inputs(image, mask, buffer);
    const both = second === undefined ? inputs : { ...inputs, second: this.texture(second) };
    const passes = EffectPasses.forEffect(source, both);
    return this.effectRunner(passes, i, (pass) => (pass.kind === 'effect' ? pass : NO_VALUES));
  }

  private mix({ mode, below, above, mask }: Of<'mix'>, i: number): PassRunner {
    const passes = EffectPasses.forMix(mode, this.texture(above), this.inputs(below, mask));
    return this.effectRunner(passes, i, (pass) => (pass.kind === 'mix' ? { args: [pass.alpha] } : NO_VALUES));
  }

  private effectRunner(passes: EffectPasses, i: number, values: (pass: FrameGraphPass) => EffectValues): PassRunner {
    return {
      run: (pass, time) => passes.render(this.gpu.renderer, this.targets[i], values(pass), time),
      setSize: (width, height) => passes.setSize(width, height),
      dispose: () => passes.dispose(),
    };
  }

  private toneMap({ tone, image }: Of<'tone'>, i: number): PassRunner {
    const exposure = uniform(0);
    const output = Fn(() => vec4(toneMaps[tone](texelHere(this.texture(image)).rgb, exposure), 1))();
    const toneMapping = new FullScreenPass(output, `tone ${tone}`);
    return {
      run: (pass) => {
        if (pass.kind === 'tone') exposure.value = pass.exposure;
        toneMapping.render(this.gpu.renderer, this.targets[i]);
      },
      dispose: () => toneMapping.dispose(),
    };
  }

  /** Radiance is measured before tone mapping; spectral bands are drawn over the input image as it is. */
  private falseColor(
    { of, image, buffer }: Of<'false-colour'>,
    i: number,
    passes: readonly FrameGraphPass[],
  ): PassRunner {
    const { uniforms, gpu } = this;
    const table = new FalseColorTable();
    const light = this.texture(of === 'radiance' ? linearSourceOf(image, passes) : image);
    const display = { tone: 'linear', grid: false } as const;
    const colors = falseColored(of, light, this.deferredPass(buffer).buffer, uniforms, table, display);
    const coloring = new FullScreenPass(Fn(() => vec4(decodeSrgb(colors.xyz), 1))(), `false colours ${of}`);
    return {
      run: (pass) => {
        if (pass.kind === 'false-colour' && pass.scale) table.use({ kind: of, ...pass.scale });
        const { value } = uniforms.exposure;
        uniforms.exposure.value = 0;
        coloring.render(gpu.renderer, this.targets[i]);
        uniforms.exposure.value = value;
      },
      dispose: () => {
        coloring.dispose();
        table.dispose();
      },
    };
  }
}

const NO_VALUES: EffectValues = { args: [] };

function lightOf({ buffer, shadows, occlusion }: Of<'light'>, index: number, { settings }: GBufferView): BufferLight {
  const occlusionRadius = occlusion ? settings.occlusionRadius : 0;
  return { buffer, index, lighting: { shadows: shadows && settings.shadows, occlusionRadius } };
}

type Of<Kind extends FrameGraphPass['kind']> = Extract<FrameGraphPass, { readonly kind: Kind }>;

const isLightOfSameBuffer = (a: FrameGraphPass, b: FrameGraphPass): boolean =>
  a.kind === 'light' && b.kind === 'light' && a.buffer === b.buffer;
