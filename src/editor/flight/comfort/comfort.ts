import { createStore } from 'zustand/vanilla';
import { pictureFlow } from '../../../flight/comfort/flow.ts';
import { SnapTurn } from '../../../flight/comfort/snapTurn.ts';
import { nextClosing, VIGNETTES, type VignetteStrength } from '../../../flight/comfort/vignette.ts';
import { observerOf } from '../../../flight/flightState.ts';
import { add, length, sub, type Vec3, ZERO } from '../../../math/vec3.ts';
import type { Editor } from '../../state/editor.ts';
import { loadPreferences, prefersReducedMotion, savePreferences } from '../../state/preferences.ts';
import type { ObserverController, Watcher } from '../observerController.ts';
import { distanceTo, type SceneLimits } from '../sceneLimits.ts';

/** Angles of turns in steps [degrees]. */
export const SNAP_ANGLES = [15, 30, 45, 90] as const;
export type SnapAngle = (typeof SNAP_ANGLES)[number];

interface ComfortSettings {
  /** Absent: as the system's wish for reduced motion has it. */
  readonly vignette?: VignetteStrength | undefined;
  /** Absent: one turns continuously. */
  readonly snapAngle?: SnapAngle | undefined;
}

export interface ComfortState extends ComfortSettings {
  /** How far the vignette is closed, 0 … 1. */
  readonly closing: number;
}

/** What is passed is this part of a scene's diagonal away. */
const NEARNESS = 0.05;
/** Smaller changes of the vignette are not seen. */
const LEAST_CHANGE = 0.004;

export const vignetteOf = ({ vignette }: ComfortSettings): VignetteStrength =>
  vignette ?? (prefersReducedMotion() ? 'mild' : 'off');

/** The page's comfort: its settings, and how far the vignette is closed just now. */
export class Comfort {
  readonly store = createStore<ComfortState>(() => ({ ...keptSettings(), closing: 0 }));
  private readonly editor: Editor;
  private readonly observerController: ObserverController;
  private closing = 0;

  constructor(editor: Editor, observerController: ObserverController) {
    this.editor = editor;
    this.observerController = observerController;
    observerController.watcher = this.watch;
    this.apply();
  }

  set(change: ComfortSettings): void {
    this.store.setState(change);
    const { vignette, snapAngle } = this.store.getState();
    savePreferences({ ...loadPreferences(), comfort: { vignette, snapAngle } });
    this.apply();
  }

  private readonly watch: Watcher = (moment, limits) => {
    if (vignetteOf(this.store.getState()) === 'off') return;
    const eye = observerOf(moment.before).position;
    const distance = surroundings(limits, add(eye, moment.walked?.before.vantage ?? ZERO));
    this.closing = nextClosing(this.closing, pictureFlow({ ...moment, distance }), moment.dt);
    const shown = this.closing < LEAST_CHANGE ? 0 : this.closing;
    if (shown === 0 || Math.abs(shown - this.store.getState().closing) > LEAST_CHANGE)
      this.store.setState({ closing: shown });
  };

  private apply(): void {
    const state = this.store.getState();
    const { snapAngle } = state;
    this.observerController.inputs.snapTurn = snapAngle ? new SnapTurn((snapAngle * Math.PI) / 180) : undefined;
    this.editor.update({ vignette: vignetteOf(state) !== 'off' });
  }
}

/** How far away what one passes is [m]: a part of the scene's size in it, and how far the scene is outside. */
const surroundings = (limits: SceneLimits | undefined, position: Vec3): number =>
  limits
    ? Math.max(NEARNESS * length(sub(limits.box.max, limits.box.min)), distanceTo(limits.box, position))
    : Number.POSITIVE_INFINITY;

function keptSettings(): ComfortSettings {
  const kept = (loadPreferences().comfort ?? {}) as Partial<Record<keyof ComfortSettings, unknown>>;
  return {
    vignette: VIGNETTES.find((strength) => strength === kept.vignette),
    snapAngle: SNAP_ANGLES.find((angle) => angle === kept.snapAngle),
  };
}

let comfort: Comfort | undefined;

/** The comfort of the page, at work from then on. */
export function openComfort(editor: Editor, observerController: ObserverController): Comfort {
  comfort ??= new Comfort(editor, observerController);
  return comfort;
}
