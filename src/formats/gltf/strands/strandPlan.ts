import type { Mesh as GltfMesh, Node as GltfNode, Primitive } from '@gltf-transform/core';
import { invert, type Mat3, multiply as times3, transpose } from '../../../math/mat3.ts';
import { linearPart, type Mat4, multiply, transformPoint } from '../../../math/mat4.ts';
import { distance, type Vec3 } from '../../../math/vec3.ts';
import { msg } from '../../../messages/message.ts';
import { type BoundingBox, boundingBox } from '../../../scene/bounds/bounds.ts';
import { MAX_SPHERES, type SphereTemplate, sphereFor } from '../../read/strands/pointSpheres.ts';
import { MAX_SURFACE_POINTS } from '../../read/strands/sweep.ts';
import type { GltfContext } from '../context.ts';
import { floatsOf } from '../read/accessors.ts';
import type { NodeTree } from '../read/nodes.ts';

/** glTF's modes without triangles. */
export const POINTS = 0;
export const LINES = 1;
export const LINE_LOOP = 2;
const LINE_STRIP = 3;
export const isStrand = (p: Primitive): boolean => p.getMode() <= LINE_STRIP;

/** Width of a line as a share of the scene's size; points are twice as wide. */
const SHARE_OF_SCENE = 1 / 500;
/** At most this share of the size of its own mesh. */
const SHARE_OF_MESH = 1 / 50;
/** Width where there is no size, as of a single point [m]. */
const ALONE = 0.01;
/** Sides of tubes, finest first. */
const SIDES = [8, 6, 4, 3];
/** Scales that differ by less are one. */
const METRIC_STEPS = 1e4;

/** How points and lines of a mesh are shown at its nodes. */
export interface StrandFrame {
  /** The same for nodes that can share it. */
  readonly key: string;
  /** Upper triangular: from the mesh's axes to ones where lengths are those of the world at the start [m]. */
  readonly metric: Mat3;
  readonly inverse: Mat3;
  /** Of lines [m]. */
  readonly width: number;
  readonly fineness: StrandFineness;
}

/** How finely all points and lines of a file are shown. */
export interface StrandFineness {
  /** One point in so many is shown, as this. */
  readonly pointStep: number;
  readonly sphere: SphereTemplate;
  /** One corner of lines in so many is shown. */
  readonly lineStep: number;
  readonly sides: number;
}

/** Widths and fineness of a file's points and lines, which have none in glTF. */
export class StrandPlan {
  private readonly tree: NodeTree;
  private readonly start: number;
  private readonly size: number;
  private readonly fineness: StrandFineness;
  private readonly boxes = new Map<GltfMesh, BoundingBox | undefined>();

  /** `nodes`: all that are shown; `start`: when the widths hold [s]. */
  constructor({ notes }: GltfContext, tree: NodeTree, nodes: readonly GltfNode[], start: number) {
    this.tree = tree;
    this.start = start;
    const made = new Map<GltfMesh, Set<string>>();
    for (const node of nodes) {
      const mesh = node.getMesh();
      if (!mesh?.listPrimitives().some(isStrand)) continue;
      const metrics = made.get(mesh) ?? new Set();
      made.set(mesh, metrics.add(metricKey(this.metric(node))));
    }
    this.size = made.size > 0 ? this.sizeOf(nodes) : 0;
    const { points, segments, surface } = countOf([...made].flatMap(([mesh, metrics]) => [...metrics].map(() => mesh)));
    const pointStep = Math.max(1, Math.ceil(points / MAX_SPHERES));
    const sides = SIDES.find((n) => n * surface <= MAX_SURFACE_POINTS) ?? SIDES[SIDES.length - 1];
    const lineStep = Math.max(1, Math.ceil((sides * surface) / MAX_SURFACE_POINTS));
    this.fineness = { pointStep, sphere: sphereFor(Math.ceil(points / pointStep)), lineStep, sides };
    if (made.size === 0) return;
    const width = (share: number): number =>
      Number((share * this.size * SHARE_OF_SCENE || share * ALONE).toPrecision(2));
    const message = msg`points and lines have no width in glTF; points are shown as spheres ${width(2)} m across and lines as tubes ${width(1)} m wide, by the size of the scene, and thinner in small meshes`;
    notes.add('info', 'gltf.primitive', '', message);
    if (pointStep > 1) {
      const few = msg`it has ${points} points; one in ${pointStep} is drawn, since at most ${MAX_SPHERES} are`;
      notes.add('warning', 'gltf.primitive', '', few);
    }
    if (lineStep > 1) {
      const few = msg`it has ${segments} pieces of lines; one in ${lineStep} is drawn, since their tubes have at most ${MAX_SURFACE_POINTS} points`;
      notes.add('warning', 'gltf.primitive', '', few);
    }
  }

  /** Of the points and lines of a node's mesh; undefined if it has none. */
  frameOf(node: GltfNode, mesh: GltfMesh): StrandFrame | undefined {
    if (!mesh.listPrimitives().some(isStrand)) return undefined;
    const metric = this.metric(node);
    const box = this.boxOf(mesh);
    const own = box ? sizeOfBox(cornersOf(box).map((p) => applied(metric, p))) : 0;
    const most = own > 0 ? own * SHARE_OF_MESH : Number.POSITIVE_INFINITY;
    const width = Math.min(this.size > 0 ? this.size * SHARE_OF_SCENE : ALONE, most);
    return { key: metricKey(metric), metric, inverse: invert(metric)!, width, fineness: this.fineness };
  }

  /** From a mesh's axes to the world, at the start; of a skinned one by its first joint. */
  private matrixOf(node: GltfNode): Mat4 {
    const [skin, joint] = [node.getSkin(), node.getSkin()?.listJoints()[0]];
    if (!skin || !joint) return this.tree.transformAt(node, this.start).matrix;
    const binds = skin.getInverseBindMatrices();
    const own = this.tree.transformAt(joint, this.start).matrix;
    if (!binds || binds.getCount() === 0) return own;
    const columns = floatsOf(binds);
    return multiply(
      own,
      Array.from({ length: 16 }, (_, i) => columns[(i % 4) * 4 + (i >> 2)]),
    );
  }

  private metric(node: GltfNode): Mat3 {
    const linear = linearPart(this.matrixOf(node));
    return triangular(times3(transpose(linear), linear));
  }

  private boxOf(mesh: GltfMesh): BoundingBox | undefined {
    if (!this.boxes.has(mesh)) {
      const all = mesh.listPrimitives().flatMap((p) => {
        const positions = p.getAttribute('POSITION');
        const box = positions && boundingBox(floatsOf(positions));
        return box ? [...box.min, ...box.max] : [];
      });
      this.boxes.set(mesh, boundingBox(all));
    }
    return this.boxes.get(mesh);
  }

  /** The diagonal of the box of all meshes in the world [m]. */
  private sizeOf(nodes: readonly GltfNode[]): number {
    const corners = nodes.flatMap((node) => {
      const mesh = node.getMesh();
      const box = mesh && this.boxOf(mesh);
      const matrix = box && this.matrixOf(node);
      return matrix ? cornersOf(box).map((p) => transformPoint(matrix, p)) : [];
    });
    return sizeOfBox(corners);
  }
}

/** `surface`: points of a tube with one side. */
function countOf(meshes: readonly GltfMesh[]) {
  const sum = { points: 0, segments: 0, surface: 0 };
  for (const p of meshes.flatMap((mesh) => mesh.listPrimitives())) {
    const corners = p.getIndices()?.getCount() ?? p.getAttribute('POSITION')?.getCount() ?? 0;
    if (!isStrand(p)) continue;
    if (p.getMode() === POINTS) sum.points += corners;
    else if (p.getMode() === LINES) {
      sum.segments += corners / 2;
      sum.surface += 2 * corners;
    } else {
      sum.segments += corners;
      sum.surface += corners + 3;
    }
  }
  return sum;
}

const applied = ([xx, xy, xz, , yy, yz, , , zz]: Mat3, [x, y, z]: Vec3): Vec3 => [
  xx * x + xy * y + xz * z,
  yy * y + yz * z,
  zz * z,
];

const metricKey = (metric: Mat3): string => {
  const most = Math.max(...metric.map(Math.abs));
  return `${most.toPrecision(5)} ${metric.map((x) => Math.round((x / most) * METRIC_STEPS)).join(' ')}`;
};

const cornersOf = ({ min, max }: BoundingBox): Vec3[] =>
  [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [(i & 1 ? max : min)[0], (i & 2 ? max : min)[1], (i & 4 ? max : min)[2]]);

function sizeOfBox(corners: readonly Vec3[]): number {
  const box = boundingBox(corners.flat());
  const size = box ? distance(box.min, box.max) : 0;
  return Number.isFinite(size) ? size : 0;
}

/** Flat transforms are taken to have this share of their greatest scale. */
const FLATTEST = 1e-3;

/** The upper triangular A with AᵀA = G (Cholesky), with a positive diagonal, for a G that may be singular; 1 for none. */
function triangular(G: Mat3): Mat3 {
  const most = Math.max(G[0], G[4], G[8]);
  if (!(most > 0) || !G.every(Number.isFinite)) return [1, 0, 0, 0, 1, 0, 0, 0, 1];
  const root = (square: number): number => Math.sqrt(Math.max(square, FLATTEST ** 2 * most));
  const xx = root(G[0]);
  const [xy, xz] = [G[1] / xx, G[2] / xx];
  const yy = root(G[4] - xy * xy);
  const yz = (G[5] - xy * xz) / yy;
  return [xx, xy, xz, 0, yy, yz, 0, 0, root(G[8] - xz * xz - yz * yz)];
}
