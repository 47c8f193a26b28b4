/**
 * Accelerates the iteration x → x + f(x) towards f = 0: takes the mixture of the last two iterates that minimizes f if
 * f were linear. A longer memory saves few iterations and costs more than the force. Source: Anderson 1965, J. ACM 12,
 * 547; Walker and Ni 2011, SIAM J. Numer. Anal. 49, 1715.
 */
export class AndersonAcceleration {
  private readonly x: Float64Array;
  private readonly f: Float64Array;
  private begun = false;

  constructor(size: number) {
    this.x = new Float64Array(size);
    this.f = new Float64Array(size);
  }

  reset(): void {
    this.begun = false;
  }

  /** Replaces x by the next iterate. */
  next(x: Float64Array, f: Float64Array): void {
    const share = this.begun ? this.shareOfLast(f) : 0;
    const { x: xLast, f: fLast } = this;
    this.begun = true;
    for (let j = 0; j < x.length; j++) {
      const place = x[j];
      x[j] += f[j] - share * (place - xLast[j] + f[j] - fLast[j]);
      xLast[j] = place;
      fLast[j] = f[j];
    }
  }

  /** Minimizes f − share·Δf. */
  private shareOfLast(f: Float64Array): number {
    const { f: last } = this;
    let along = 0;
    let square = 0;
    for (let j = 0; j < f.length; j++) {
      const change = f[j] - last[j];
      along += change * f[j];
      square += change * change;
    }
    return square > 0 ? along / square : 0;
  }
}
