/** An object that is kept in the browser under a key; empty if there is none, or none that can be read. */
export function loadObject(key: string): Readonly<Record<string, unknown>> {
  try {
    const kept: unknown = JSON.parse(localStorage.getItem(key) ?? '{}');
    return typeof kept === 'object' && kept !== null ? (kept as Record<string, unknown>) : {};
  } catch {
    return {};
  }
}

/** Keeps an object in the browser; without storage (private window, full disk) it lasts for this visit. */
export function saveObject(key: string, object: object): void {
  try {
    localStorage.setItem(key, JSON.stringify(object));
  } catch {
    // Nothing is kept.
  }
}
