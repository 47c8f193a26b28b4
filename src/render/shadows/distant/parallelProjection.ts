import { float, vec3, vec4 } from 'three/tsl';
import type { Float } from '../../../shaders/types.ts';
import type { LayerTable } from '../atlas/layerTable.ts';
import type { ShadowAtlas } from '../atlas/shadowAtlas.ts';
import type { LayerProjection } from '../casters/casterMesh.ts';
import { projectToLayer, readParallelRows, readTileTexel } from './parallelReceiver.ts';

/** Change of slope over three texels that may be the edge of a shadow [texels]. */
export const parallelEdgeThreshold = (): Float => float(1);

/** Projects occluders onto layers of a distant light: heights are along the light's direction [texels]. `side`: of a tile. */
export const parallelProjection = (map: ShadowAtlas, table: LayerTable, side: number): LayerProjection => ({
  project(layer, x) {
    const place = projectToLayer(readParallelRows(table, layer), x, float(0)).toVar();
    const tile = readTileTexel(table, layer);
    return {
      clip: vec4(map.clipOf(place.xy), map.depthOf(place.z.div(tile.w)), 1),
      spot: vec3(place.z, place.xy.sub(tile.xy).div(side)),
    };
  },
  heightOf({ x: height, y, z }) {
    return { height, outside: y.lessThan(0).or(y.greaterThan(1)).or(z.lessThan(0)).or(z.greaterThan(1)) };
  },
});
