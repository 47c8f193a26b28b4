/** Panels that a step may bring to the front, with what each may show; the first unless another is named. */
export const INSTRUMENTS = {
  clocks: [],
  diagram: ['spacetime', 'energy'],
  energy: ['change', 'drift', 'dragLoss', 'total', 'kinetic', 'potential', 'fastest', 'momentum', 'angularMomentum'],
} as const;

export type InstrumentName = keyof typeof INSTRUMENTS;

export interface Instrument {
  readonly panel: InstrumentName;
  /** One of those of INSTRUMENTS. */
  readonly view: string | undefined;
}

/** `PANEL`, or `PANEL VIEW` as in `energy fastest`. Undefined if there is no such panel, or it has no such view. */
export function parseInstrument(text: string): Instrument | undefined {
  const [panel = '', view, more] = text.split(' ');
  if (!isInstrument(panel) || more !== undefined) return undefined;
  const views: readonly string[] = INSTRUMENTS[panel];
  return view === undefined || views.includes(view) ? { panel, view: view ?? views[0] } : undefined;
}

const isInstrument = (name: string): name is InstrumentName => Object.hasOwn(INSTRUMENTS, name);
