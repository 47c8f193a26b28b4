import { type Hypersurface, LIGHT_SURFACES, type LightSurface, type LightSurfaceName } from './lightSurfaces.ts';
import { shallowCone } from './shallowCone.ts';

export type HypersurfaceName = LightSurfaceName | 'shallow-cone';

/** Which events a picture shows. */
export interface HypersurfaceChoice {
  readonly hypersurface: HypersurfaceName;
  /** λ of the shallow cone ct′ = −λr′, 0 < λ < 1; the others have none. */
  readonly coneSlope: number;
}

export const hypersurfaceOf = ({ hypersurface, coneSlope }: HypersurfaceChoice): Hypersurface =>
  hypersurface === 'shallow-cone' ? shallowCone(coneSlope) : LIGHT_SURFACES[hypersurface];

/** What light travels on in such a picture. */
export const lightSurfaceOf = (choice: HypersurfaceChoice): LightSurface =>
  LIGHT_SURFACES[hypersurfaceOf(choice).lightSurface];
