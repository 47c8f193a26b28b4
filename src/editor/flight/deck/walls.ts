import type { Obstacles } from '../../../flight/collision/obstacles.ts';
import { prepareObstacles, sceneObstacles } from '../../../nodes/flights/sceneObstacles.ts';
import type { PictureSpec } from '../../../nodes/socketValues.ts';
import type { Scene } from '../../../scene/types.ts';

/** How long preparation may hold up the page at a stretch [ms]; one large mesh may take longer. */
const STRETCH = 6;
/** An edit is waited for so long [ms]: who drags a slider changes the speed of light at every picture. */
const SETTLED = 300;

/** The walls of the scene that is shown, prepared beside the pictures when they are first asked for. */
export class Walls {
  private scene: Scene | undefined;
  private c = 0;
  private obstacles: Obstacles | undefined;
  private readonly onFailure: (error: unknown) => void;

  /** `onFailure`: of a scene of which no walls can be made. */
  constructor(onFailure: (error: unknown) => void) {
    this.onFailure = onFailure;
  }

  /** Undefined while they are prepared. */
  of({ scene, speedOfLight }: PictureSpec): Obstacles | undefined {
    if (scene !== this.scene || speedOfLight !== this.c) {
      this.scene = scene;
      this.c = speedOfLight;
      this.obstacles = undefined;
      this.prepare(scene, speedOfLight).catch(this.onFailure);
    }
    return this.obstacles;
  }

  private async prepare(scene: Scene, c: number): Promise<void> {
    const isWanted = (): boolean => scene === this.scene && c === this.c;
    await passed(SETTLED);
    let begun = performance.now();
    const pause = async (): Promise<void> => {
      if (performance.now() - begun < STRETCH) return;
      await passed(0);
      begun = performance.now();
    };
    if (isWanted()) await prepareObstacles(scene, pause);
    if (isWanted()) this.obstacles = sceneObstacles(scene, c);
  }
}

const passed = (ms: number): Promise<void> => new Promise((done) => setTimeout(done, ms));
