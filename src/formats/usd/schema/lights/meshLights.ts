import { cross, length, scale, sub, type Vec3 } from '../../../../math/vec3.ts';
import { msg } from '../../../../messages/message.ts';
import { pointAt } from '../../../../scene/mesh/polygons.ts';
import type { Mesh } from '../../../../scene/types.ts';
import { report } from '../../diagnostics.ts';
import { textAt } from '../../layer/attributes.ts';
import type { PrimSpec } from '../../layer/layer.ts';
import { targetsOf } from '../../layer/query.ts';
import type { StageContext } from '../context.ts';
import type { MaterialSyncMode, MaterialTable } from '../materials/materialTable.ts';
import { emissionOf, lightFlag } from './lightInputs.ts';

const SYNC_MODES: readonly MaterialSyncMode[] = ['materialGlowTintsLight', 'independent', 'noMaterialResponse'];

/** GeometryLight prims by the path of the geometry that they target. */
export function geometryLights(prims: Iterable<PrimSpec>, found = new Map<string, PrimSpec>()): Map<string, PrimSpec> {
  for (const prim of prims) {
    if (prim.typeName === 'GeometryLight') for (const target of targetsOf(prim, 'geometry')) found.set(target, prim);
    geometryLights(prim.children.values(), found);
  }
  return found;
}

/** A mesh light: its geometry's prim and the prim with the light inputs. */
export interface MeshLight {
  readonly mesh: PrimSpec;
  readonly light: PrimSpec;
}

/** The prim with a mesh's light inputs: itself, with UsdLuxMeshLightAPI, or a GeometryLight; undefined if it is not a light. */
export function meshLightOf(mesh: PrimSpec, ofGeometry: ReadonlyMap<string, PrimSpec>): MeshLight | undefined {
  const schemas = mesh.metadata.get('apiSchemas');
  const op = schemas?.type === 'texts' ? schemas.op : {};
  const names = [...(op.explicit ?? []), ...(op.prepended ?? []), ...(op.appended ?? [])];
  const light = names.includes('MeshLightAPI') ? mesh : ofGeometry.get(mesh.path);
  return light && { mesh, light };
}

/** The mesh [m] of a light, with emissive materials. */
export function withEmission(
  context: StageContext,
  table: MaterialTable,
  { mesh: prim, light }: MeshLight,
  mesh: Mesh,
): Mesh {
  const written = textAt(light, 'light:materialSyncMode', undefined);
  const mode =
    SYNC_MODES.find((m) => m === written) ?? (light === prim ? 'materialGlowTintsLight' : 'noMaterialResponse');
  const area = lightFlag(context, light, 'normalize') ? areaOf(mesh) / context.unit ** 2 : 1;
  const radiance = scale(emissionOf(context, light), area > 0 ? 1 / area : 0);
  const message = msg`it is seen to shine; what it lights, the reference renderer alone shows`;
  report(context, 'info', 'usd.mesh-light', prim.path, message);
  const groups = mesh.groups.map((group) => ({ ...group, material: table.emissive(group.material, radiance, mode) }));
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
