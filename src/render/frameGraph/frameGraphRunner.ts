import { Fn, uniform, vec3, vec4 } from 'three/tsl';
import { HalfFloatType, type PerspectiveCamera, type RenderTarget } from 'three/webgpu';
import type { FrameGraph, FrameGraphPass } from '../../scene/frameGraph/frameGraph.ts';
import { readShaderText } from '../../scene/shaderText/shaderText.ts';
import { toneMaps } from '../../shaders/color/toneMap.ts';
import type { DeferredPass, GBufferView } from '../deferredPass.ts';
import { dataTarget } from '../gbuffer/gbuffer.ts';
import type { Gpu } from '../gpu/device.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import { FullScreenPass, texelHere } from '../gpu/fullScreenPass.ts';
import { decodeSrgb } from '../post/display/display.ts';
import { FalseColorTable, falseColored } from '../post/display/falseColor.ts';
import { EffectPasses, type PassInputs } from '../post/effectPasses.ts';
import { StillImage } from './stillImage.ts';
import { allocateTargets, linearSourceOf } from './targetAllocation.ts';

/** What a G-buffer is drawn of, and how all passes are told of it. */
export interface BoundRenderView {
  readonly view: GBufferView;
  /** Sets the uniforms and the camera. */
  readonly bind: () => void;
}

/** What changes from sample to sample. */
interface SampleInput {
  readonly views: readonly [BoundRenderView, ...BoundRenderView[]];
  readonly camera: PerspectiveCamera;
  /** World time of the observer [s]. */
  readonly time: number;
}

/** Hears of a step's image. */
export type PassListener = (step: number, image: RenderTarget) => void;

/** A step that is drawn by passes, not by a plate. */
interface PassRunner {
  /** Its numbers may be others than those that it was made with; its kind may not. */
  run(step: FrameGraphPass, time: number): void;
  setSize?(width: number, height: number): void;
  dispose(): void;
}

/** Effects as they are in the light: half floats hold all that a screen or an eye could tell apart. */
const IMAGE_TYPE = HalfFloatType;

/** Carries out plans of one shape. Its passes are made once; numbers are uniforms. Images that are not needed at the same time share a target. */
export class FrameGraphRunner {
  private readonly gpu: Gpu;
  private readonly uniforms: FrameUniforms;
  private readonly deferredPass: (buffer: number) => DeferredPass;
  private readonly pool: readonly RenderTarget[];
  /** Of each step that is one. */
  private readonly stills: readonly (StillImage | undefined)[];
  /** Of each step, where its image is; light is where its plate has it. */
  private readonly targets: readonly RenderTarget[];
  /** Of each step; undefined of light and stills. */
  private readonly passRunners: readonly (PassRunner | undefined)[];
  /** Of each step that is light, which of its G-buffer's. */
  private readonly lightIndices: readonly number[];

  constructor(plan: FrameGraph, gpu: Gpu, uniforms: FrameUniforms, plate: (buffer: number) => DeferredPass) {
    this.gpu = gpu;
    this.uniforms = uniforms;
    this.deferredPass = plate;
    const { passes: steps } = plan;
    const { slots, count } = allocateTargets(steps);
    this.pool = Array.from({ length: count }, () => dataTarget(1, IMAGE_TYPE));
    this.lightIndices = steps.map((step, i) => steps.slice(0, i).filter((other) => isLightOf(other, step)).length);
    this.stills = steps.map((step) => (step.kind === 'still' ? new StillImage(step.still) : undefined));
    this.targets = steps.map((step, i) =>
      step.kind === 'light'
        ? plate(step.buffer).light(this.lightIndices[i])
        : (this.stills[i]?.target ?? this.pool[slots[i]]),
    );
    this.passRunners = steps.map((step, i) => this.make(step, i, steps));
  }

  setSize(width: number, height: number): void {
    for (const target of this.pool) target.setSize(width, height);
    for (const sized of [...this.passRunners, ...this.stills]) sized?.setSize?.(width, height);
  }

  /** Draws what does not change from frame to frame, where it is another; to be called before `draw` is only rehearsed. */
  updateStills({ passes: steps }: Pick<FrameGraph, 'passes'>): void {
    steps.forEach((step, i) => {
      if (step.kind === 'still') this.stills[i]?.update(this.gpu.renderer, step.still);
    });
  }

  /** One sample; gives the target that it is in. `seen` is told of each step's image while it is there: later steps may draw over it. */
  draw({ passes: steps }: FrameGraph, { views, camera, time }: SampleInput, seen?: PassListener): RenderTarget {
    views.forEach(({ view, bind: look }, buffer) => {
      look();
      this.deferredPass(buffer).drawGeometry(view, camera);
      steps.forEach((step, i) => {
        if (step.kind === 'light' && step.buffer === buffer) this.drawLight(step, i, view, camera);
      });
    });
    this.updateStills({ passes: steps });
    let looking = views.length - 1;
    const look = (buffer: number): void => {
      if (buffer !== looking) views[buffer].bind();
      looking = buffer;
    };
    steps.forEach((step, i) => {
      if ('buffer' in step) look(step.buffer);
      this.passRunners[i]?.run(step, time);
      seen?.(i, this.targets[i]);
    });
    look(0);
    return this.targets[steps.length - 1];
  }

  dispose(): void {
    for (const made of [...this.passRunners, ...this.stills]) made?.dispose();
    for (const target of this.pool) target.dispose();
  }

  private drawLight(
    { buffer, shadows, occlusion }: Extract<FrameGraphPass, { kind: 'light' }>,
    i: number,
    subject: GBufferView,
    camera: PerspectiveCamera,
  ): void {
    const { settings } = subject;
    const occlusionRadius = occlusion ? settings.occlusionRadius : 0;
    const lighting = { shadows: shadows && settings.shadows, occlusionRadius };
    this.deferredPass(buffer).drawLight(subject, camera, lighting, this.lightIndices[i]);
  }

  private make(step: FrameGraphPass, i: number, steps: readonly FrameGraphPass[]): PassRunner | undefined {
    switch (step.kind) {
      case 'light':
      case 'still':
        return undefined;
      case 'occlusion':
        return this.occlusion(step, i);
      case 'effect':
        return this.effect(step, i);
      case 'mix':
        return this.mix(step, i);
      case 'tone':
        return this.toneMap(step, i);
      case 'false-colour':
        return this.falseColor(step, i, steps);
    }
  }

  private texture = (image: number) => this.targets[image].texture;

  private inputs(image: number, mask?: number, buffer?: number): PassInputs {
    return {
      image: this.texture(image),
      uniforms: this.uniforms,
      type: IMAGE_TYPE,
      ...(mask !== undefined && { mask: this.texture(mask) }),
      ...(buffer !== undefined && { buffer: this.deferredPass(buffer).buffer }),
    };
  }

  private occlusion({ buffer }: Of<'occlusion'>, i: number): PassRunner {
    const plate = this.deferredPass(buffer);
    const { renderer } = this.gpu;
    const gray = new FullScreenPass(vec4(vec3(texelHere(plate.opennessTexture).x), 1), 'occlusion');
    return {
      run: (step) => {
        if (step.kind !== 'occlusion') return;
        plate.openness(step.radius === 0 ? undefined : step.radius);
        gray.render(renderer, this.targets[i]);
      },
      dispose: () => gray.dispose(),
    };
  }

  private effect({ effect, image, buffer, mask }: Of<'effect'>, i: number): PassRunner {
    const of = typeof effect === 'string' ? effect : readShaderText(effect.text);
    const passes = EffectPasses.forEffect(of, this.inputs(image, mask, buffer));
    return this.effectRunner(passes, i, (step) => (step.kind === 'effect' ? step.args : []));
  }

  private mix({ mode, below, above, mask }: Of<'mix'>, i: number): PassRunner {
    const passes = EffectPasses.forMix(mode, this.texture(above), this.inputs(below, mask));
    return this.effectRunner(passes, i, (step) => (step.kind === 'mix' ? [step.alpha] : []));
  }

  private effectRunner(passes: EffectPasses, i: number, args: (step: FrameGraphPass) => readonly number[]): PassRunner {
    return {
      run: (step, time) => passes.render(this.gpu.renderer, this.targets[i], args(step), time),
      setSize: (width, height) => passes.setSize(width, height),
      dispose: () => passes.dispose(),
    };
  }

  private toneMap({ tone, image }: Of<'tone'>, i: number): PassRunner {
    const exposure = uniform(0);
    const output = Fn(() => vec4(toneMaps[tone](texelHere(this.texture(image)).rgb, exposure), 1))();
    const pass = new FullScreenPass(output, `tone ${tone}`);
    return {
      run: (step) => {
        if (step.kind === 'tone') exposure.value = step.exposure;
        pass.render(this.gpu.renderer, this.targets[i]);
      },
      dispose: () => pass.dispose(),
    };
  }

  /** Luminance is that of the light before its tone curve; what lies under the bands is the image as it comes. */
  private falseColor(
    { of, image, buffer }: Of<'false-colour'>,
    i: number,
    steps: readonly FrameGraphPass[],
  ): PassRunner {
    const { uniforms, gpu } = this;
    const table = new FalseColorTable();
    const light = this.texture(of === 'radiance' ? linearSourceOf(image, steps) : image);
    const look = { tone: 'linear', grid: false } as const;
    const colors = falseColored(of, light, this.deferredPass(buffer).buffer, uniforms, table, look);
    const pass = new FullScreenPass(Fn(() => vec4(decodeSrgb(colors.xyz), 1))(), `false colours ${of}`);
    return {
      run: (step) => {
        if (step.kind === 'false-colour' && step.scale) table.use({ kind: of, ...step.scale });
        const { value } = uniforms.exposure;
        uniforms.exposure.value = 0;
        pass.render(gpu.renderer, this.targets[i]);
        uniforms.exposure.value = value;
      },
      dispose: () => {
        pass.dispose();
        table.dispose();
      },
    };
  }
}

type Of<Kind extends FrameGraphPass['kind']> = Extract<FrameGraphPass, { readonly kind: Kind }>;

const isLightOf = (a: FrameGraphPass, b: FrameGraphPass): boolean =>
  a.kind === 'light' && b.kind === 'light' && a.buffer === b.buffer;
