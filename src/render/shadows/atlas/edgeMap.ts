import {
  abs,
  attribute,
  Fn,
  float,
  floor,
  int,
  ivec2,
  Loop,
  max,
  screenCoordinate,
  textureLoad,
  varying,
  vec4,
} from 'three/tsl';
import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  Mesh,
  NoBlending,
  NodeMaterial,
  PerspectiveCamera,
  type RenderTarget,
  Scene,
  type Texture,
  type WebGPURenderer,
} from 'three/webgpu';
import type { Float, Int, Vec2, Vec4 } from '../../../shaders/types.ts';
import { FullScreenPass } from '../../gpu/fullScreenPass.ts';
import { shadowAtlasTarget } from './shadowAtlasTarget.ts';

/** Where the edges of an atlas are stored in its texture, and what counts as an edge. */
export interface EdgeLayout {
  /** Side of a cell [texels of the atlas]; the filter's radius is at most this. */
  readonly cell: number;
  /** Least change of slope between neighbouring texels that may be the edge of a shadow, given the height of the highest of them. */
  readonly threshold: (highest: Float) => Float;
  /** Number of cells (columns, rows). */
  readonly size: Vec2;
  /** The row of the texture at which the cells begin. */
  readonly row: Int;
  /** Texels of the texture → clip space. */
  readonly clipOf: (texels: Vec2) => Vec2;
}

/**
 * Where the edges of shadows can be: per cell of an atlas, the height of the highest edge within a cell's width of it, 0 where there is none. A point that is
 * farther from all edges above it than the filter's radius is wholly lit or wholly in shadow. The cells are stored below the heights in the same texture,
 * because shaders have few texture units.
 */
export class EdgeMap {
  private readonly cellTarget = shadowAtlasTarget(false);
  private readonly cells: FullScreenPass;
  private readonly edgeScene = new Scene();
  private readonly camera = new PerspectiveCamera();

  constructor(heights: Texture, layout: EdgeLayout) {
    this.cells = new FullScreenPass(Fn(() => highestEdge(heights, layout))(), 'edges of cells');
    this.edgeScene.add(makeEdgeQuad(this.cellTarget.texture, layout));
  }

  /** Finds the edges of the heights in `target`, in `columns` × `rows` cells, and writes them below these heights. */
  render(renderer: WebGPURenderer, target: RenderTarget, columns: number, rows: number): void {
    this.cellTarget.setSize(columns, rows);
    this.cells.render(renderer, this.cellTarget);
    renderer.setRenderTarget(target);
    renderer.autoClear = false;
    renderer.render(this.edgeScene, this.camera);
    renderer.autoClear = true;
  }

  dispose(): void {
    for (const { geometry, material } of this.edgeScene.children as Mesh<BufferGeometry, NodeMaterial>[]) {
      geometry.dispose();
      material.dispose();
    }
    this.cells.dispose();
    this.cellTarget.dispose();
  }
}

/** A quad that writes, for each cell, the highest edge of it and its eight neighbours into the rows below the heights. */
function makeEdgeQuad(cellTexture: Texture, { size, row, clipOf }: EdgeLayout): Mesh {
  const material = new NodeMaterial();
  material.name = 'edges near cells';
  const cell = varying(attribute<'vec3'>('position', 'vec3').xy.mul(size), 'v_cell');
  const place = attribute<'vec3'>('position', 'vec3')
    .xy.mul(size)
    .add(vec4(0, row, 0, 0).xy);
  material.vertexNode = vec4(clipOf(place), 0.5, 1);
  material.fragmentNode = Fn(() => highestNearby(cellTexture, cell))();
  material.side = DoubleSide;
  material.blending = NoBlending;
  material.depthTest = false;
  material.depthWrite = false;
  const corners = Float32Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0);
  const geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(corners, 3));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  return mesh;
}

/** Largest height at the bends within a cell, along its rows and columns. */
function highestEdge(heights: Texture, { cell, threshold }: EdgeLayout): Vec4 {
  const corner = ivec2(floor(screenCoordinate)).mul(int(cell)).toVar();
  const highest = float(0).toVar();
  const load = (x: Int, y: Int) => textureLoad(heights, corner.add(ivec2(x, y))).x.toVar();
  for (const at of [(i: Int, j: Int) => load(i, j), (i: Int, j: Int) => load(j, i)])
    Loop({ start: int(0), end: int(cell), type: 'int', condition: '<' }, ({ i: j }) => {
      const before = at(int(-1), int(j));
      const here = at(int(0), int(j));
      Loop({ start: int(0), end: int(cell), type: 'int', condition: '<' }, ({ i }) => {
        const after = at(int(i).add(int(1)), int(j));
        const upper = max(before, max(here, after)).toVar();
        const isEdge = abs(before.add(after).sub(here.mul(2))).greaterThan(threshold(upper));
        highest.assign(max(highest, isEdge.select(upper, float(0))));
        before.assign(here);
        here.assign(after);
      });
    });
  return vec4(highest, 0, 0, 1);
}

function highestNearby(edges: Texture, cell: Vec2): Vec4 {
  const here = ivec2(floor(cell)).toVar();
  const highest = float(0).toVar();
  for (const y of [-1, 0, 1])
    for (const x of [-1, 0, 1]) highest.assign(max(highest, textureLoad(edges, here.add(ivec2(x, y))).x));
  return vec4(highest, 0, 0, 1);
}
