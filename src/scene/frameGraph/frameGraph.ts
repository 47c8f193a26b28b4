import type { ToneMapping } from '../../spectrum/display/toneMap.ts';
import type { FalseColorQuantity, ValueRange } from '../../spectrum/falseColor/falseColor.ts';
import type { BufferSettings } from '../settings/settings.ts';
import type { EffectId, MixMode } from './effects.ts';
import type { StillPixels } from './still.ts';

/*
 * A frame graph: a list of passes, each of which makes an image from those before it. Built by the nodes; executed by the rasterizer
 * (render/frameGraph/) and the reference (reference/post/frameGraph.ts), with the same result. Plain data.
 */

/** A G-buffer beside that of the picture's own settings, seen by the same observer. */
export interface FrameGraphBuffer extends BufferSettings {
  /** Place among the scenes that the renderer was given. */
  readonly scene: number;
}

/** An effect in the words of whoever wrote it (scene/shaderText/). */
export interface CustomEffect {
  readonly text: string;
}

/** One step, by what it refers to images and G-buffers with. */
export type FrameGraphPassOf<Image, Buffer> =
  /** The G-buffer shaded: linear light. `occlusion`: what hides the sky of a place dims its light. */
  | { readonly kind: 'light'; readonly buffer: Buffer; readonly shadows: boolean; readonly occlusion: boolean }
  /** What was made once, for one camera at one time; it lies in the picture as `fitStill` of scene/frameGraph/still.ts says. */
  | { readonly kind: 'still'; readonly still: StillPixels }
  /** The share of the sky that each place sees, as a grey image; 1 where nothing is. `radius`: as `occlusionRadius` of the settings; 0: what fits the scene. */
  | { readonly kind: 'occlusion'; readonly buffer: Buffer; readonly radius: number }
  | {
      readonly kind: 'effect';
      readonly effect: EffectId | CustomEffect;
      /** arg1 … arg4 */
      readonly args: readonly number[];
      readonly image: Image;
      readonly buffer: Buffer;
      /** Its first channel tells how much of the effect is to be seen. */
      readonly mask?: Image;
    }
  | {
      readonly kind: 'mix';
      readonly mode: MixMode;
      readonly alpha: number;
      readonly below: Image;
      readonly above: Image;
      readonly mask?: Image;
    }
  /** Light to what a screen can show: 0 … 1, still linear. Where it is metered, that is added to the exposure [EV]. */
  | {
      readonly kind: 'tone';
      readonly tone: ToneMapping;
      readonly exposure: number;
      readonly metering: 'automatic' | 'resting-eye' | 'manual';
      readonly image: Image;
    }
  /** Numbers of a G-buffer, or of the light, as colours, 0 … 1 and linear too. `scale`: absent until somebody has measured. */
  | {
      readonly kind: 'false-colour';
      readonly of: FalseColorQuantity;
      readonly scale?: ValueRange;
      readonly image: Image;
      readonly buffer: Buffer;
    };

/** It refers to steps before it, and to G-buffers, by their places. */
export type FrameGraphPass = FrameGraphPassOf<number, number>;

/** The last step is the light of the picture, which is then exposed and tone mapped as the settings say. Equal steps are there once. */
export interface FrameGraph {
  /** G-buffers 1, 2 …; number 0 is that of the settings themselves, of the renderer's first scene. */
  readonly extraBuffers: readonly FrameGraphBuffer[];
  readonly passes: readonly FrameGraphPass[];
}

/** A picture takes at most so many steps, so many G-buffers and so many stills: each is a texture or several, of the picture's size or a still's. */
export const MAX_PASSES = 64;
export const MAX_BUFFERS = 4;
export const MAX_STILL_IMAGES = 4;

/** The images that a step is made of. */
export function inputImages<Image>(step: FrameGraphPassOf<Image, unknown>): readonly Image[] {
  switch (step.kind) {
    case 'light':
    case 'still':
    case 'occlusion':
      return [];
    case 'mix':
      return [step.below, step.above, ...(step.mask === undefined ? [] : [step.mask])];
    case 'effect':
      return [step.image, ...(step.mask === undefined ? [] : [step.mask])];
    default:
      return [step.image];
  }
}

/**
 * Whether tone curves are within the plan. Then the metering works there, by the light of the picture's first G-buffer; otherwise it is the plan's light that
 * is metered, exposed and tone mapped.
 */
export const includesToneMapping = (plan: FrameGraph | undefined): boolean =>
  plan?.passes.some(({ kind }) => kind === 'tone') ?? false;

/** Settings, plans and steps as text, by which they are told apart; a still goes by its key. */
export const contentKey = (data: unknown): string =>
  JSON.stringify(data, (_, value: unknown) => (ArrayBuffer.isView(value) ? undefined : value));

/** What a plan is like, but for its numbers: plans of one shape are drawn by the same shaders. */
export const frameGraphStructure = ({ extraBuffers, passes: steps }: FrameGraph): string =>
  JSON.stringify([extraBuffers.length, steps.map(withoutNumericValues)]);

function withoutNumericValues(step: FrameGraphPass): unknown {
  switch (step.kind) {
    case 'effect':
      return { ...step, args: 0 };
    case 'mix':
      return { ...step, alpha: 0 };
    case 'tone':
      return { ...step, exposure: 0 };
    case 'still':
      return { ...step, still: 0 };
    case 'occlusion':
      return { ...step, radius: 0 };
    case 'false-colour':
      return { ...step, scale: 0 };
    default:
      return step;
  }
}
