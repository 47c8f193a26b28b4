import { listed, type Message, msg } from '../../messages/message.ts';
import { makeObject } from '../defaults.ts';
import { isLocalLight, lightKind } from '../lights/lightKinds.ts';
import { pointAt } from '../mesh/polygons.ts';
import { isProperStretch } from '../mesh/stretch.ts';
import { deforms, sampleTimes } from '../motion/motion.ts';
import { motionKind } from '../motion/motions.ts';
import type { Diagnostic, LocalLight, Mesh, Motion, Scene, SceneCamera, SceneObject } from '../types.ts';
import { MAX_PER_CODE, type SceneCode } from './diagnosticCodes.ts';
import { problem, seconds } from './motionFindings.ts';

/**
 * Problems of a scene at the speed of light c [m/s], object by object. Objects with errors cannot be rendered and must be removed or fixed.
 * @example
 * const tooFast = makeObject({
 *   path: '/Ball',
 *   mesh: sphere(1),
 *   motion: { kind: 'uniform', pose: IDENTITY_POSE, velocity: [12, 0, 0] },
 * });
 * const [problem] = validate(makeScene({ name: 'one', objects: [tooFast] }), 10);
 * problem.severity; // 'error'
 * problem.code; // 'motion.superluminal'
 */
export function validate(scene: Scene, c: number): Diagnostic[] {
  const meshes = new Map<Mesh, MeshFindings>();
  const findingsOf = (mesh: Mesh): MeshFindings => {
    const known = meshes.get(mesh) ?? { faults: meshFaults(mesh, scene), notFinite: notFiniteIn(mesh) };
    meshes.set(mesh, known);
    return known;
  };
  return [
    ...duplicatePaths(scene),
    ...oncePerThing(scene.objects, (object) => validateObject(object, findingsOf(object.mesh), c)),
    ...scene.cameras.flatMap((camera) => validateRigidMotion(camera, c)),
    ...scene.lights.flatMap((light) => (isLocalLight(light) ? validateLocalLight(light, c) : [])),
  ];
}

/**
 * Of the pieces of one thing a warning of each kind is told once: a simulation may have hundreds. Of many things, such as instances of a mesh, the first are
 * told, and how many there are in all.
 */
function oncePerThing(
  objects: readonly SceneObject[],
  findingsOf: (object: SceneObject) => readonly Diagnostic[],
): Diagnostic[] {
  const told = new Set<string>();
  const counts = new Map<string, number>();
  const found = objects.flatMap((object) =>
    findingsOf(object).filter(({ severity, code }) => {
      if (severity === 'error') return true;
      const key = `${object.pieceOf} ${code}`;
      if (object.pieceOf !== undefined && told.has(key)) return false;
      told.add(key);
      const count = (counts.get(code) ?? 0) + 1;
      counts.set(code, count);
      return count <= MAX_PER_CODE;
    }),
  );
  const summaries = [...counts].filter(([, count]) => count > MAX_PER_CODE);
  return [
    ...found,
    ...summaries.map(([code, count]): Diagnostic => {
      const { severity, place } = found.find((each) => each.code === code)!;
      const message = msg`and ${count - MAX_PER_CODE} others like it; the first ${MAX_PER_CODE} are listed`;
      return { severity, code, place, message };
    }),
  ];
}

function duplicatePaths({ objects }: Scene): Diagnostic[] {
  const seen = new Set<string>();
  return objects
    .filter(({ path }) => seen.has(path) || !seen.add(path))
    .map(({ path }) => problem('error', 'scene.duplicate-path', path, msg`two objects have this path; rename one`));
}

/** Later checks rely on earlier ones, so the first check that finds an error is the last. */
function validateObject(object: SceneObject, mesh: MeshFindings, c: number): Diagnostic[] {
  const { path, motion } = object;
  const found = [
    ...mesh.faults.map(({ severity, code, message }) => problem(severity, code, path, message)),
    ...validateTimes(motion, path),
    ...validateLifetime(object),
    ...validateAuthoring(object),
    ...validateStretch(object),
  ];
  if (hasError(found)) return found;
  found.push(...finiteness(object, mesh));
  return hasError(found) ? found : [...found, ...motionKind(motion).validateSpeed(object, c)];
}

const hasError = (found: readonly Diagnostic[]): boolean => found.some(({ severity }) => severity === 'error');

/** Problems of a mesh, cached per mesh. */
interface MeshFindings {
  readonly faults: readonly MeshFault[];
  /** The first vertex that is not finite. */
  readonly notFinite: number | undefined;
}
type MeshFault = Pick<Diagnostic, 'severity' | 'message'> & { readonly code: SceneCode };

const error = (code: SceneCode, message: Message): MeshFault => ({ severity: 'error', code, message });

function meshFaults(mesh: Mesh, scene: Scene): MeshFault[] {
  const vertices = mesh.positions.length / 3;
  if (mesh.indices.length === 0 || vertices === 0)
    return [{ severity: 'warning', code: 'mesh.empty', message: msg`has no triangle; nothing of it is drawn` }];
  const beyond = mesh.indices.find((v) => v >= vertices);
  if (beyond !== undefined)
    return [error('mesh.index', msg`a triangle names vertex ${beyond}, but there are only ${vertices}`)];
  if (mesh.normals.length !== mesh.positions.length || mesh.uvs.length !== 2 * vertices) {
    const message = msg`${vertices} vertices need as many normals and uvs, not ${mesh.normals.length / 3} and ${mesh.uvs.length / 2}`;
    return [error('mesh.length', message)];
  }
  const foreign = mesh.groups.find(({ material }) => material >= scene.materials.length);
  if (foreign)
    return [
      error('mesh.material', msg`uses material ${foreign.material}, but there are only ${scene.materials.length}`),
    ];
  return degenerateTriangles(mesh);
}

function notFiniteIn({ positions }: Mesh): number | undefined {
  const at = positions.findIndex((x) => !Number.isFinite(x));
  return at < 0 ? undefined : Math.floor(at / 3);
}

/** Coincident or collinear corners in f32: area less than a millionth of the square of the longest side. */
function degenerateTriangles({ positions, indices }: Mesh): MeshFault[] {
  let count = 0;
  for (let i = 0; i < indices.length; i += 3)
    if (isDegenerate(positions, indices[i], indices[i + 1], indices[i + 2])) count++;
  if (count === 0) return [];
  const message = msg`${count} of ${indices.length / 3} triangles have no area; merge double points, or leave it: they are not drawn`;
  return [{ severity: 'warning', code: 'mesh.degenerate', message }];
}

function isDegenerate(p: Float32Array, a: number, b: number, c: number): boolean {
  const [i, j, k] = [3 * a, 3 * b, 3 * c];
  const [ux, uy, uz] = [p[j] - p[i], p[j + 1] - p[i + 1], p[j + 2] - p[i + 2]];
  const [vx, vy, vz] = [p[k] - p[i], p[k + 1] - p[i + 1], p[k + 2] - p[i + 2]];
  const area2 = (uy * vz - uz * vy) ** 2 + (uz * vx - ux * vz) ** 2 + (ux * vy - uy * vx) ** 2;
  const longest = Math.max(ux * ux + uy * uy + uz * uz, vx * vx + vy * vy + vz * vz);
  return area2 <= 1e-12 * longest * longest;
}

function validateTimes(motion: Motion, path: string): Diagnostic[] {
  const times = sampleTimes(motion);
  if (!times) return [];
  const samples = motionKind(motion).sampleCount(motion);
  if (times.length < 2 || samples !== times.length) {
    return [
      problem(
        'error',
        'motion.samples',
        path,
        msg`${times.length} times and ${samples} samples; a motion needs as many of both, two or more`,
      ),
    ];
  }
  const k = times.findIndex((t, i) => i > 0 && !(t > times[i - 1]));
  if (k < 0) return [];
  return [
    problem(
      'error',
      'motion.times',
      path,
      msg`sample ${k} is at ${seconds(times[k])}, not after sample ${k - 1} at ${seconds(times[k - 1])}; times must rise`,
    ),
  ];
}

function validateLifetime({ lifetime, path }: SceneObject): Diagnostic[] {
  if (lifetime.birth < lifetime.death) return [];
  return [
    problem(
      'warning',
      'object.lifetime',
      path,
      msg`ends at ${seconds(lifetime.death)}, not after it begins at ${seconds(lifetime.birth)}; it is never there`,
    ),
  ];
}

function validateAuthoring({ authoredIn, motion, path }: SceneObject): Diagnostic[] {
  if (authoredIn === 'world' || !deforms(motion)) return [];
  const message = msg`deforming points are authored in the rest frame, which they do not share; they are taken as the world’s`;
  return [problem('info', 'motion.rest-points', path, message)];
}

function validateStretch({ path, mesh, stretch, motion }: SceneObject): Diagnostic[] {
  if (!stretch) return [];
  if (!isProperStretch(stretch)) {
    const message = msg`its stretch is ${stretch.join(', ')}; give it finite numbers and a positive determinant, or apply it to the mesh`;
    return [problem('error', 'object.stretch', path, message)];
  }
  if (!deforms(motion) && !mesh.quadric) return [];
  return [
    problem(
      'error',
      'object.stretch',
      path,
      msg`it deforms, or is a round solid, and has a stretch; apply it to the mesh`,
    ),
  ];
}

function finiteness({ path, mesh, motion }: SceneObject, { notFinite }: MeshFindings): Diagnostic[] {
  if (notFinite !== undefined) {
    const message = msg`vertex ${notFinite} is at ${pointAt(mesh.positions, notFinite).join(', ')}`;
    return [problem('error', 'mesh.not-finite', path, message)];
  }
  const bad = motionKind(motion).nonFiniteText(motion);
  return bad === undefined ? [] : [problem('error', 'motion.not-finite', path, bad)];
}

function validateLocalLight(light: LocalLight, c: number): Diagnostic[] {
  const sizes: readonly string[] = lightKind(light).sizes;
  const wrong = Object.entries(light).flatMap(([name, value]) =>
    sizes.includes(name) && !(value >= 0 && Number.isFinite(value)) ? [msg`its ${name} is ${value} m`] : [],
  );
  if (wrong.length > 0)
    return [problem('error', 'light.size', light.path, msg`${listed(wrong)}; give it a size of 0 m or more`)];
  if (!light.color.every(Number.isFinite)) {
    const message = msg`its colour is ${light.color.join(', ')}; give it three numbers`;
    return [problem('error', 'light.color', light.path, message)];
  }
  return validateRigidMotion(light, c);
}

/** The frame of a camera or a light is a point, so only its own speed counts. */
function validateRigidMotion({ path, motion }: SceneCamera | LocalLight, c: number): Diagnostic[] {
  const found = validateTimes(motion, path);
  if (hasError(found)) return found;
  const bad = motionKind(motion).nonFiniteText(motion);
  if (bad !== undefined) return [problem('error', 'motion.not-finite', path, bad)];
  return motionKind(motion).validateSpeed({ ...makeObject({ path, mesh: POINT }), motion }, c);
}

const POINT: Mesh = {
  positions: new Float32Array(3),
  normals: new Float32Array(3),
  uvs: new Float32Array(2),
  indices: new Uint32Array(0),
  groups: [],
  doubleSided: false,
};
