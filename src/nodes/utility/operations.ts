/** Operations of the math node, by menu names. All angles in radians. */
export const OPERATIONS = {
  add: (a, b) => a + b,
  subtract: (a, b) => a - b,
  multiply: (a, b) => a * b,
  divide: (a, b) => a / b,
  power: (a, b) => a ** b,
  minimum: (a, b) => Math.min(a, b),
  maximum: (a, b) => Math.max(a, b),
  /** Floored remainder: in [0, b) also for negative a. */
  modulo: (a, b) => a - b * Math.floor(a / b),
  /** a + (b − a) · factor */
  mix: (a, b, factor) => a + (b - a) * factor,
  clamp: (a, low, high) => Math.min(Math.max(a, low), high),
  'square-root': (a) => Math.sqrt(a),
  exponential: (a) => Math.exp(a),
  logarithm: (a) => Math.log(a),
  absolute: (a) => Math.abs(a),
  round: (a) => Math.round(a),
  floor: (a) => Math.floor(a),
  sine: (a) => Math.sin(a),
  cosine: (a) => Math.cos(a),
  tangent: (a) => Math.tan(a),
  arcsine: (a) => Math.asin(a),
  arccosine: (a) => Math.acos(a),
  /** The angle of the point (b, a). */
  arctangent: (a, b) => Math.atan2(a, b),
  /** γ = 1/√(1 − β²), without cancellation near 1. */
  'gamma-of-beta': (beta) => 1 / Math.sqrt((1 - beta) * (1 + beta)),
  /** β = √(1 − 1/γ²). */
  'beta-of-gamma': (gamma) => Math.sqrt((1 - 1 / gamma) * (1 + 1 / gamma)),
} as const satisfies Record<string, (...values: [a: number, b: number, c: number]) => number>;

export type Operation = keyof typeof OPERATIONS;

/** Number of operands. */
export const arity = (operation: Operation): number => OPERATIONS[operation].length;
