import { isLanguageTag, type LanguageTag, preferredLanguage } from '../../messages/languages.ts';
import { loadObject, saveObject } from './storedObject.ts';

/** The user's settings of the page itself; stored in the browser, not in the document. */
export interface Preferences {
  readonly language: LanguageTag;
  readonly captions: boolean;
  /** Whether the legend of false colours is shown. */
  readonly legend: boolean;
  /** Whether nodes of the graph show pictures. */
  readonly nodePictures: boolean;
  /** Whether the picture shows clocks. */
  readonly clockLabels: boolean;
  /** Pictures drawn per second at most; absent: as many as the screen shows. */
  readonly frameRate?: FrameRate | undefined;
  /** How the user flies, and in what comfort, as the code of the flight deck reads it; absent: as at first. */
  readonly flight?: unknown;
  readonly comfort?: unknown;
}

/** Choices of how many pictures are drawn per second at most. */
export const FRAME_RATES = [60, 30] as const;
export type FrameRate = (typeof FRAME_RATES)[number];

const PREFERENCES_KEY = 'slowlight.preferences';

/** Without readable preferences (private window, full disk) the browser's settings apply. */
export function loadPreferences(): Preferences {
  const kept: Partial<Record<keyof Preferences, unknown>> = loadObject(PREFERENCES_KEY);
  const language = isLanguageTag(kept.language) ? kept.language : preferredLanguage(navigator.languages);
  return {
    language,
    captions: kept.captions !== false,
    legend: kept.legend !== false,
    nodePictures: kept.nodePictures !== false,
    clockLabels: kept.clockLabels === true,
    frameRate: FRAME_RATES.find((rate) => rate === kept.frameRate),
    flight: kept.flight,
    comfort: kept.comfort,
  };
}

export const savePreferences = (preferences: Preferences): void => saveObject(PREFERENCES_KEY, preferences);

export const prefersReducedMotion = (): boolean => matchMedia('(prefers-reduced-motion: reduce)').matches;
