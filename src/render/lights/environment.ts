import { isDistantLight, isLocalLight } from '../../scene/lights/lightKinds.ts';
import { directLights, sceneDome, sceneNightSky, showsDome } from '../../scene/lights/sceneLights.ts';
import type { ColorMode } from '../../scene/settings/settings.ts';
import type { Scene } from '../../scene/types.ts';
import type { HalfAtlas } from '../../shaders/tables/halfAtlas.ts';
import { type LobeTable, lobeTable } from '../brdf/lobeTable.ts';
import { coloredLights } from '../color/lightSpectra.ts';
import { LineTable } from '../color/lineTable.ts';
import type { RadianceAccumulator } from '../color/radiance.ts';
import type { Observation } from '../geometry/observation.ts';
import type { FloatTable } from '../gpu/floatTable.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import { DistantLightTable } from './distantLightTable.ts';
import { DomeSky } from './kinds/domeLight.ts';
import type { LitSurface } from './kinds/litSurface.ts';
import { CosmicBackground } from './kinds/nightSky.ts';
import type { LightReach, LightSet, SkyPixel } from './lightSet.ts';
import { LightTable } from './lightTable.ts';
import type { DomeMaps } from './sky/domeMaps.ts';
import type { DomeTexture } from './sky/domeTexture.ts';

/** All light sources of a scene. */
export class Environment {
  readonly distantLights: DistantLightTable;
  readonly localLights: LightTable;
  /** Of the surfaces that they shine on. */
  readonly lobes: LobeTable;
  /** The scene's dome, a clear day's, or that of starlight, which is not seen itself. */
  private readonly sky: DomeSky;
  private readonly showsDome: boolean;
  /** In the order in which what surfaces reflect of them is added. */
  private readonly sets: { readonly [R in LightReach]: LightSet };

  /** `table` and `atlas` are read by the scene's shaders; upload `table` after `update`. `Picture`: for a dome with a picture. */
  constructor(scene: Scene, table: FloatTable, atlas: HalfAtlas, Picture?: typeof DomeTexture) {
    this.lobes = lobeTable(atlas);
    const lines = new LineTable(table);
    const direct = directLights(scene);
    const colored = coloredLights(scene);
    this.distantLights = new DistantLightTable(direct.filter(isDistantLight), colored, lines, table);
    this.localLights = new LightTable(direct.filter(isLocalLight), colored, lines, table);
    this.sky = new DomeSky(sceneDome(scene), lines, atlas, Picture);
    this.showsDome = showsDome(scene);
    this.sets = {
      distant: this.distantLights,
      local: this.localLights,
      sky: this.sky,
      stars: new CosmicBackground(sceneNightSky(scene)),
    };
  }

  /** Once per picture; places are relative to the observer's event. */
  update(observation: Observation, colors: ColorMode): void {
    for (const lights of Object.values(this.sets)) lights.update(observation, colors);
  }

  /** Shows another picture of the scene's dome, of the same size. */
  showDome(maps: DomeMaps): void {
    this.sky.show(maps);
  }

  /** Adds what a surface reflects of all lights. */
  addReflected(surface: LitSurface, accumulator: RadianceAccumulator): void {
    for (const lights of Object.values(this.sets)) lights.addReflected(surface, accumulator);
  }

  /** Adds what is seen behind everything: the sky, then the other lights. */
  addBackground(pixel: SkyPixel, uniforms: FrameUniforms, accumulator: RadianceAccumulator): void {
    const { sky, ...others } = this.sets;
    const seen = Object.values(others);
    for (const lights of this.showsDome ? [sky, ...seen] : seen) lights.addBackground(pixel, uniforms, accumulator);
  }

  dispose(): void {
    this.sky.dispose();
  }
}
