import { isDistantLight, isLocalLight } from '../../scene/lights/lightKinds.ts';
import { directLights, sceneDome, sceneNightSky } from '../../scene/lights/sceneLights.ts';
import type { ColorMode } from '../../scene/settings/settings.ts';
import type { NightSky, Scene } from '../../scene/types.ts';
import type { HalfAtlas } from '../../shaders/tables/halfAtlas.ts';
import { coloredLights } from '../color/lightSpectra.ts';
import { LineTable } from '../color/lineTable.ts';
import type { Observation } from '../geometry/observation.ts';
import type { FloatTable } from '../gpu/floatTable.ts';
import { DistantLightTable } from './distantLightTable.ts';
import { DomeSky } from './kinds/domeLight.ts';
import { LightTable } from './lightTable.ts';

/** Where a scene's light comes from. */
export class Environment {
  readonly distantLights: DistantLightTable;
  readonly localLights: LightTable;
  /** The scene's dome, or a clear day's. */
  readonly sky: DomeSky;
  readonly nightSky: NightSky | undefined;

  /** `table` and `atlas`: what the scene's shaders read; the first is to be uploaded after `update`. */
  constructor(scene: Scene, table: FloatTable, atlas: HalfAtlas) {
    const lines = new LineTable(table);
    const direct = directLights(scene);
    const colored = coloredLights(scene);
    this.nightSky = sceneNightSky(scene);
    this.distantLights = new DistantLightTable(direct.filter(isDistantLight), colored, lines, table);
    this.localLights = new LightTable(direct.filter(isLocalLight), colored, lines, table);
    this.sky = new DomeSky(sceneDome(scene), lines, atlas);
  }

  /** Once per picture; places are relative to the observer's event. */
  update(observation: Observation, colors: ColorMode): void {
    this.distantLights.update(colors);
    this.localLights.update(observation, colors);
    this.sky.update(colors);
  }

  dispose(): void {
    this.sky.dispose();
  }
}
