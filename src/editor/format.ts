/** Formats a number: few digits, a true minus sign, thin spaces between thousands. */
export function formatNumber(value: number, digits = 3): string {
  if (!Number.isFinite(value)) return value > 0 ? '∞' : value < 0 ? '−∞' : '–';
  const size = Math.abs(value);
  if (size !== 0 && (size >= 1e9 || size < 1e-3)) return minus(value.toExponential(Math.max(0, digits - 1)));
  const decimals = size === 0 ? 0 : Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
  return group(minus(value.toFixed(Math.min(decimals, 12))));
}

/** Formats an integer. */
export const formatCount = (value: number): string => group(minus(String(Math.round(value))));

/** β near 1 with all its nines: 0.5, 0.99, 0.999999. */
export function formatBeta(beta: number): string {
  if (beta === 0) return '0';
  const nines = Math.max(0, Math.floor(1e-6 - Math.log10(Math.max(1e-12, 1 - beta))));
  return beta.toFixed(Math.min(12, 3 + Math.max(0, nines - 1)));
}

/** [s] → `2.35 s`, `3 min 05 s` */
export function formatSeconds(t: number): string {
  if (Math.abs(t) < 600) return `${minus(t.toFixed(2))} s`;
  const minutes = Math.trunc(t / 60);
  return `${minus(String(minutes))} min ${String(Math.floor(Math.abs(t % 60))).padStart(2, '0')} s`;
}

/** [m/s] */
export const formatSpeed = (v: number): string => `${formatNumber(v)} m/s`;

/** [m] → `0.12 mm`; lengths below 1 mm with two digits. */
export function formatLength(x: number): string {
  if (x >= 1) return `${formatNumber(x)} m`;
  const [unit, size] = x >= 1e-3 ? ['mm', 1e-3] : x >= 1e-6 ? ['µm', 1e-6] : (['nm', 1e-9] as const);
  return `${formatNumber(x / size, 2)} ${unit}`;
}

/** What is rounded to 0 has no sign. */
const minus = (text: string): string => (/^-[0.]+$/.test(text) ? text.slice(1) : text.replaceAll('-', '−'));

/** 299792458 → `299 792 458`; numbers of four digits are not grouped. */
function group(text: string): string {
  const [whole = '', part] = text.split('.');
  const grouped = whole.replace('−', '').length > 4 ? whole.replace(/\B(?=(\d{3})+$)/g, '\u202f') : whole;
  return part ? `${grouped}.${part}` : grouped;
}
