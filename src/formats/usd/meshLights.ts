import { cross, length, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { pointAt } from '../../scene/polygons.ts';
import type { Mesh } from '../../scene/types.ts';
import { textAt } from './attributes.ts';
import { report, type StageContext, targetsOf } from './context.ts';
import type { PrimSpec } from './layer.ts';
import { brightnessOf, lightFlag } from './lightInputs.ts';
import type { MaterialTable } from './materials.ts';

/** How a light that is a mesh goes with its material (`light:materialSyncMode` of UsdLux). */
export type GlowMode = 'materialGlowTintsLight' | 'independent' | 'noMaterialResponse';
const MODES: readonly GlowMode[] = ['materialGlowTintsLight', 'independent', 'noMaterialResponse'];

/** The prims that light what a GeometryLight's relationship `geometry` leads to, by the path of that. */
export function geometryLights(prims: Iterable<PrimSpec>, found = new Map<string, PrimSpec>()): Map<string, PrimSpec> {
  for (const prim of prims) {
    if (prim.typeName === 'GeometryLight') for (const target of targetsOf(prim, 'geometry')) found.set(target, prim);
    geometryLights(prim.children.values(), found);
  }
  return found;
}

/** The prim that says how a mesh shines: itself, with UsdLuxMeshLightAPI, or a GeometryLight; undefined where it does not. */
function lightOn(prim: PrimSpec, ofGeometry: ReadonlyMap<string, PrimSpec>): PrimSpec | undefined {
  const schemas = prim.metadata.get('apiSchemas');
  const names =
    schemas?.type === 'texts'
      ? [...(schemas.op.explicit ?? []), ...(schemas.op.prepended ?? []), ...(schemas.op.appended ?? [])]
      : [];
  return names.includes('MeshLightAPI') ? prim : ofGeometry.get(prim.path);
}

/** The mesh [m] with materials that shine where its prim is a light. */
export function glowing(
  context: StageContext,
  table: MaterialTable,
  prim: PrimSpec,
  mesh: Mesh,
  ofGeometry: ReadonlyMap<string, PrimSpec>,
): Mesh {
  const light = lightOn(prim, ofGeometry);
  if (!light) return mesh;
  const written = textAt(light, 'light:materialSyncMode', undefined);
  const mode = MODES.find((m) => m === written) ?? (light === prim ? 'materialGlowTintsLight' : 'noMaterialResponse');
  const area = lightFlag(context, light, 'normalize') ? areaOf(mesh) / context.unit ** 2 : 1;
  const radiance = area > 0 ? scale(brightnessOf(context, light), 1 / area) : scale(brightnessOf(context, light), 0);
  const message = 'it is seen to shine; what it lights, the reference renderer alone shows';
  report(context, 'info', 'usd.mesh-light', prim.path, message);
  const groups = mesh.groups.map((group) => ({ ...group, material: table.glowing(group.material, radiance, mode) }));
  return { ...mesh, groups };
}

function areaOf({ positions, indices }: Mesh): number {
  let area = 0;
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c]: Vec3[] = [0, 1, 2].map((k) => pointAt(positions, indices[i + k]));
    area += length(cross(sub(b, a), sub(c, a))) / 2;
  }
  return area;
}
