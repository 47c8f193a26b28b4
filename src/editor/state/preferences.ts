import { isLanguageTag, type LanguageTag, preferredLanguage } from '../../messages/languages.ts';

/** The user's settings of the page itself; stored in the browser, not in the document. */
export interface Preferences {
  readonly language: LanguageTag;
  readonly captions: boolean;
  /** Whether the legend of false colours is shown. */
  readonly legend: boolean;
  /** Whether nodes of the graph show pictures. */
  readonly nodePictures: boolean;
  /** How the user flies, and in what comfort, as the code of the flight deck reads it; absent: as at first. */
  readonly flight?: unknown;
  readonly comfort?: unknown;
}

const PREFERENCES_KEY = 'slowlight.preferences';

/** Without readable preferences (private window, full disk) the browser's settings apply. */
export function loadPreferences(): Preferences {
  const kept = readStoredPreferences();
  const language = isLanguageTag(kept.language) ? kept.language : preferredLanguage(navigator.languages);
  return {
    language,
    captions: kept.captions !== false,
    legend: kept.legend !== false,
    nodePictures: kept.nodePictures !== false,
    flight: kept.flight,
    comfort: kept.comfort,
  };
}

export function savePreferences(preferences: Preferences): void {
  try {
    localStorage.setItem(PREFERENCES_KEY, JSON.stringify(preferences));
  } catch {
    // Without storage the choice lasts for this visit.
  }
}

function readStoredPreferences(): Partial<Record<keyof Preferences, unknown>> {
  try {
    const kept: unknown = JSON.parse(localStorage.getItem(PREFERENCES_KEY) ?? '{}');
    return typeof kept === 'object' && kept !== null ? kept : {};
  } catch {
    return {};
  }
}

export const prefersReducedMotion = (): boolean => matchMedia('(prefers-reduced-motion: reduce)').matches;
