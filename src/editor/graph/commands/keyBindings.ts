/** A key combination as `Mod+Shift+Z`. `Mod` is Ctrl, or ⌘ on a Mac. */
export type KeyBinding = string;

type KeyEvent = Pick<KeyboardEvent, 'key' | 'code' | 'ctrlKey' | 'metaKey' | 'shiftKey' | 'altKey'>;

/** `Mod++` is Ctrl and +. */
const partsOf = (keys: KeyBinding): string[] => keys.split(/(?<=[^+])\+/);

/**
 * Whether an event matches a binding: by character (`key`) where that is a letter, otherwise by physical key (`code`).
 */
export function matchesKeyBinding(event: KeyEvent, keys: KeyBinding): boolean {
  const parts = partsOf(keys);
  const key = parts.pop()!;
  const wants = (modifier: string) => parts.includes(modifier);
  if ((event.ctrlKey || event.metaKey) !== wants('Mod') || event.altKey !== wants('Alt')) return false;
  // Whether signs need Shift depends on the keyboard layout.
  const isSign = /^[^\p{L}\p{N}]$/u.test(key) && key !== ' ';
  if (!isSign && event.shiftKey !== wants('Shift')) return false;
  if (key === 'Space') return event.key === ' ';
  if (/^[A-Z]$/.test(key))
    return /^[a-z]$/i.test(event.key) ? event.key.toUpperCase() === key : event.code === `Key${key}`;
  return event.key === key;
}

const SIGNS: Readonly<Record<string, string>> = {
  Shift: '⇧',
  ArrowLeft: '←',
  ArrowRight: '→',
  ArrowUp: '↑',
  ArrowDown: '↓',
  Delete: 'Del',
  Enter: '↵',
};

/** For display: `Ctrl ⇧ Z`. */
export const formatKeyBinding = (keys: KeyBinding): string[] =>
  partsOf(keys).map((part) => (part === 'Mod' ? (isMac() ? '⌘' : 'Ctrl') : (SIGNS[part] ?? part)));

const isMac = (): boolean => /Mac|iPhone|iPad/.test(navigator.platform);
