import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { emptyGraph, type GraphEdge } from '../../../graph/document/document.ts';
import type { CanvasPoint } from '../../../graph/edits/commands.ts';
import { freePosition } from '../cards/cardGeometry.ts';
import { layeredLayout, nodePositions } from './layeredLayout.ts';

const edge = (from: string, to: string): GraphEdge => ({
  from: { node: from, output: 'out' },
  to: { node: to, input: 'in' },
});
const SIZES: Readonly<Record<string, CanvasPoint>> = { tall: [200, 300], wide: [400, 60] };
const sizeOf = (id: string): CanvasPoint => SIZES[id] ?? [200, 80];

/** Random graphs: edges go from lower to higher node numbers, except for a few back edges. */
const graphs = fc
  .record({
    count: fc.integer({ min: 1, max: 30 }),
    pairs: fc.array(fc.tuple(fc.nat(29), fc.nat(29)), { maxLength: 60 }),
  })
  .map(({ count, pairs }) => {
    const nodes = Array.from({ length: count }, (_, i) => `n${i}`);
    return { nodes, edges: pairs.map(([a, b]) => edge(`n${a % count}`, `n${b % count}`)) };
  });

describe('the layered layout', () => {
  it('places every node without overlaps, for any edges', () => {
    fc.assert(
      fc.property(graphs, ({ nodes, edges }) => {
        const at = layeredLayout(nodes, edges, sizeOf);
        expect(Object.keys(at).sort()).toEqual([...nodes].sort());
        for (const a of nodes) {
          for (const b of nodes) {
            if (a === b) continue;
            const apart = [0, 1].some((axis) => Math.abs(at[a]![axis]! - at[b]![axis]!) >= sizeOf(a)[axis]!);
            expect(apart, `${a} and ${b}`).toBe(true);
          }
        }
      }),
    );
  });

  it('orders nodes from left to right along edges, without cycles', () => {
    fc.assert(
      fc.property(graphs, ({ nodes, edges }) => {
        const number = (id: string) => Number(id.slice(1));
        const forward = edges.filter(({ from, to }) => number(from.node) < number(to.node));
        const at = layeredLayout(nodes, forward, sizeOf);
        for (const { from, to } of forward) expect(at[from.node]![0]).toBeLessThan(at[to.node]![0]);
      }),
    );
  });

  it('does not cross independent chains', () => {
    const at = layeredLayout(['b1', 'a1', 'a2', 'b2'], [edge('a1', 'a2'), edge('b1', 'b2')], sizeOf);
    expect(Math.sign(at.a1![1] - at.b1![1])).toBe(Math.sign(at.a2![1] - at.b2![1]));
  });

  it('leaves room for the widest node of a column, and for tall nodes', () => {
    const at = layeredLayout(
      ['wide', 'tall', 'x', 'y'],
      [edge('wide', 'x'), edge('tall', 'x'), edge('tall', 'y')],
      sizeOf,
    );
    expect(at.x![0]).toBeGreaterThanOrEqual(400);
    expect(Math.abs(at.wide![1] - at.tall![1])).toBeGreaterThanOrEqual(60);
  });
});

it('nodes without position are laid out below the others', () => {
  const graph = {
    ...emptyGraph(),
    nodes: { a: { type: 'box', params: {} }, b: { type: 'box', params: {} }, c: { type: 'box', params: {} } },
    layout: { a: [10, 20] as const },
    edges: { 'c.in': edge('b', 'c') },
  };
  const at = nodePositions(graph, sizeOf);
  expect(at.a).toEqual([10, 20]);
  expect(at.b![1]).toBeGreaterThan(100);
  expect(at.c![0]).toBeGreaterThan(at.b![0]);
});

it('a new node is moved down until it overlaps none', () => {
  const boxes = [0, 90, 180].map((y) => ({ at: [0, y] as const, size: [200, 80] as const }));
  expect(freePosition([50, 10], [200, 80], boxes)).toEqual([50, 284]);
  expect(freePosition([250, 10], [200, 80], boxes)).toEqual([250, 10]);
});
