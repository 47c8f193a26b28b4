import type { CDPSession, Locator, Page } from 'playwright-core';

/** Fingers on the screen of a page. */
export class Touches {
  private readonly session: CDPSession;
  private readonly fingers = new Map<number, { readonly x: number; readonly y: number }>();

  static async on(page: Page): Promise<Touches> {
    return new Touches(await page.context().newCDPSession(page));
  }

  private constructor(session: CDPSession) {
    this.session = session;
  }

  async down(id: number, x: number, y: number): Promise<void> {
    this.fingers.set(id, { x, y });
    await this.tell('touchStart');
  }

  /** In steps, as fingers do. */
  async move(id: number, dx: number, dy: number, steps = 4): Promise<void> {
    for (let step = 0; step < steps; step++) {
      const { x, y } = this.fingers.get(id)!;
      this.fingers.set(id, { x: x + dx / steps, y: y + dy / steps });
      await this.tell('touchMove');
    }
  }

  async up(id: number): Promise<void> {
    const place = this.fingers.get(id)!;
    this.fingers.delete(id);
    // The end of a touch names what is lifted.
    await this.session.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [{ id, ...place }] });
  }

  /** A finger on the middle of something, or so many pixels beside it. */
  async downOn(id: number, what: Locator, [dx, dy] = [0, 0] as readonly [number, number]): Promise<void> {
    const { x, y, width, height } = (await what.boundingBox())!;
    await this.down(id, x + width / 2 + dx, y + height / 2 + dy);
  }

  private async tell(type: 'touchStart' | 'touchMove'): Promise<void> {
    const touchPoints = [...this.fingers].map(([id, place]) => ({ id, ...place }));
    await this.session.send('Input.dispatchTouchEvent', { type, touchPoints });
  }
}
