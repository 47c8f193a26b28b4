import { Fn, uniform, vec3, vec4 } from 'three/tsl';
import { HalfFloatType, type PerspectiveCamera, type RenderTarget } from 'three/webgpu';
import type { Plan, Step } from '../../scene/plan.ts';
import { readShaderText } from '../../scene/shaderText/shaderText.ts';
import { toneMaps } from '../../shaders/toneMap.ts';
import type { Gpu } from '../device.ts';
import { decode } from '../display.ts';
import { EffectPasses, type PassInputs } from '../effects/effectPasses.ts';
import { FalseColorTable, falseColored } from '../falseColor.ts';
import { FullScreen, texelHere } from '../fullScreen.ts';
import type { Plate, Subject } from '../plate.ts';
import { dataTarget } from '../targets.ts';
import type { Uniforms } from '../uniforms.ts';
import { lightUnder, slotsOf } from './slots.ts';
import { StillImage } from './stillImage.ts';

/** What a G-buffer is drawn of, and how all passes are told of it. */
export interface Sitting {
  readonly subject: Subject;
  /** Sets the uniforms and the camera. */
  readonly look: () => void;
}

/** What changes from sample to sample. */
interface Moment {
  readonly sittings: readonly [Sitting, ...Sitting[]];
  readonly camera: PerspectiveCamera;
  /** World time of the observer [s]. */
  readonly time: number;
}

/** Hears of a step's image. */
export type Seen = (step: number, image: RenderTarget) => void;

/** A step that is drawn by passes, not by a plate. */
interface Drawn {
  /** Its numbers may be others than those that it was made with; its kind may not. */
  draw(step: Step, time: number): void;
  setSize?(width: number, height: number): void;
  dispose(): void;
}

/** Effects as they are in the light: half floats hold all that a screen or an eye could tell apart. */
const TYPE = HalfFloatType;

/** Carries out plans of one shape. Its passes are made once; numbers are uniforms. Images that are not needed at the same time share a target. */
export class Composition {
  private readonly gpu: Gpu;
  private readonly uniforms: Uniforms;
  private readonly plate: (buffer: number) => Plate;
  private readonly pool: readonly RenderTarget[];
  /** Of each step that is one. */
  private readonly stills: readonly (StillImage | undefined)[];
  /** Of each step, where its image is; light is where its plate has it. */
  private readonly targets: readonly RenderTarget[];
  /** Of each step; undefined of light and stills. */
  private readonly drawn: readonly (Drawn | undefined)[];
  /** Of each step that is light, which of its G-buffer's. */
  private readonly lights: readonly number[];

  constructor(plan: Plan, gpu: Gpu, uniforms: Uniforms, plate: (buffer: number) => Plate) {
    this.gpu = gpu;
    this.uniforms = uniforms;
    this.plate = plate;
    const { steps } = plan;
    const { slots, count } = slotsOf(steps);
    this.pool = Array.from({ length: count }, () => dataTarget(1, TYPE));
    this.lights = steps.map((step, i) => steps.slice(0, i).filter((other) => isLightOf(other, step)).length);
    this.stills = steps.map((step) => (step.kind === 'still' ? new StillImage(step.still) : undefined));
    this.targets = steps.map((step, i) =>
      step.kind === 'light'
        ? plate(step.buffer).light(this.lights[i])
        : (this.stills[i]?.target ?? this.pool[slots[i]]),
    );
    this.drawn = steps.map((step, i) => this.make(step, i, steps));
  }

  setSize(width: number, height: number): void {
    for (const target of this.pool) target.setSize(width, height);
    for (const sized of [...this.drawn, ...this.stills]) sized?.setSize?.(width, height);
  }

  /** Draws what does not change from frame to frame, where it is another; to be called before `draw` is only rehearsed. */
  develop({ steps }: Pick<Plan, 'steps'>): void {
    steps.forEach((step, i) => {
      if (step.kind === 'still') this.stills[i]?.develop(this.gpu.renderer, step.still);
    });
  }

  /** One sample; gives the target that it is in. `seen` is told of each step's image while it is there: later steps may draw over it. */
  draw({ steps }: Plan, { sittings, camera, time }: Moment, seen?: Seen): RenderTarget {
    sittings.forEach(({ subject, look }, buffer) => {
      look();
      this.plate(buffer).drawGeometry(subject, camera);
      steps.forEach((step, i) => {
        if (step.kind === 'light' && step.buffer === buffer) this.drawLight(step, i, subject, camera);
      });
    });
    this.develop({ steps });
    let looking = sittings.length - 1;
    const look = (buffer: number): void => {
      if (buffer !== looking) sittings[buffer].look();
      looking = buffer;
    };
    steps.forEach((step, i) => {
      if ('buffer' in step) look(step.buffer);
      this.drawn[i]?.draw(step, time);
      seen?.(i, this.targets[i]);
    });
    look(0);
    return this.targets[steps.length - 1];
  }

  dispose(): void {
    for (const made of [...this.drawn, ...this.stills]) made?.dispose();
    for (const target of this.pool) target.dispose();
  }

  private drawLight(
    { buffer, shadows, occlusion }: Extract<Step, { kind: 'light' }>,
    i: number,
    subject: Subject,
    camera: PerspectiveCamera,
  ): void {
    const { settings } = subject;
    const occlusionRadius = occlusion ? settings.occlusionRadius : 0;
    const lighting = { shadows: shadows && settings.shadows, occlusionRadius };
    this.plate(buffer).drawLight(subject, camera, lighting, this.lights[i]);
  }

  private make(step: Step, i: number, steps: readonly Step[]): Drawn | undefined {
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
        return this.tone(step, i);
      case 'false-colour':
        return this.falseColour(step, i, steps);
    }
  }

  private texture = (image: number) => this.targets[image].texture;

  private inputs(image: number, mask?: number, buffer?: number): PassInputs {
    return {
      image: this.texture(image),
      uniforms: this.uniforms,
      type: TYPE,
      ...(mask !== undefined && { mask: this.texture(mask) }),
      ...(buffer !== undefined && { buffer: this.plate(buffer).buffer }),
    };
  }

  private occlusion({ buffer }: Of<'occlusion'>, i: number): Drawn {
    const plate = this.plate(buffer);
    const { renderer } = this.gpu;
    const grey = new FullScreen(vec4(vec3(texelHere(plate.opennessTexture).x), 1), 'occlusion');
    return {
      draw: (step) => {
        if (step.kind !== 'occlusion') return;
        plate.openness(step.radius === 0 ? undefined : step.radius);
        grey.render(renderer, this.targets[i]);
      },
      dispose: () => grey.dispose(),
    };
  }

  private effect({ effect, image, buffer, mask }: Of<'effect'>, i: number): Drawn {
    const of = typeof effect === 'string' ? effect : readShaderText(effect.text);
    const passes = EffectPasses.of(of, this.inputs(image, mask, buffer));
    return this.drawnBy(passes, i, (step) => (step.kind === 'effect' ? step.args : []));
  }

  private mix({ mode, below, above, mask }: Of<'mix'>, i: number): Drawn {
    const passes = EffectPasses.mixing(mode, this.texture(above), this.inputs(below, mask));
    return this.drawnBy(passes, i, (step) => (step.kind === 'mix' ? [step.alpha] : []));
  }

  private drawnBy(passes: EffectPasses, i: number, args: (step: Step) => readonly number[]): Drawn {
    return {
      draw: (step, time) => passes.render(this.gpu.renderer, this.targets[i], args(step), time),
      setSize: (width, height) => passes.setSize(width, height),
      dispose: () => passes.dispose(),
    };
  }

  private tone({ tone, image }: Of<'tone'>, i: number): Drawn {
    const exposure = uniform(0);
    const output = Fn(() => vec4(toneMaps[tone](texelHere(this.texture(image)).rgb, exposure), 1))();
    const pass = new FullScreen(output, `tone ${tone}`);
    return {
      draw: (step) => {
        if (step.kind === 'tone') exposure.value = step.exposure;
        pass.render(this.gpu.renderer, this.targets[i]);
      },
      dispose: () => pass.dispose(),
    };
  }

  /** Luminance is that of the light before its tone curve; what lies under the bands is the image as it comes. */
  private falseColour({ of, image, buffer }: Of<'false-colour'>, i: number, steps: readonly Step[]): Drawn {
    const { uniforms, gpu } = this;
    const table = new FalseColorTable();
    const light = this.texture(of === 'radiance' ? lightUnder(image, steps) : image);
    const look = { tone: 'linear', grid: false } as const;
    const colors = falseColored(of, light, this.plate(buffer).buffer, uniforms, table, look);
    const pass = new FullScreen(Fn(() => vec4(decode(colors.xyz), 1))(), `false colours ${of}`);
    return {
      draw: (step) => {
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

type Of<Kind extends Step['kind']> = Extract<Step, { readonly kind: Kind }>;

const isLightOf = (a: Step, b: Step): boolean => a.kind === 'light' && b.kind === 'light' && a.buffer === b.buffer;
