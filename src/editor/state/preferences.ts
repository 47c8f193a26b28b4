import { type Language, preferredLanguage } from '../i18n/i18n.ts';

/** What a person chose about the page itself; kept in the browser, and no part of the document. */
export interface Preferences {
  readonly language: Language;
  readonly captions: boolean;
  /** Of false colours. */
  readonly legend: boolean;
  /** Pictures on the nodes of the graph. */
  readonly nodePictures: boolean;
}

const PREFERENCES_KEY = 'slowlight.preferences';

/** Nothing kept, or nothing readable (private windows, full disks): the browser's own wishes. */
export function loadPreferences(): Preferences {
  const kept = readStoredPreferences();
  const language =
    kept.language === 'en' || kept.language === 'zh' ? kept.language : preferredLanguage(navigator.languages);
  return {
    language,
    captions: kept.captions !== false,
    legend: kept.legend !== false,
    nodePictures: kept.nodePictures !== false,
  };
}

export function savePreferences(preferences: Preferences): void {
  try {
    localStorage.setItem(PREFERENCES_KEY, JSON.stringify(preferences));
  } catch {
    // The page works without; the choice lasts for this visit.
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
