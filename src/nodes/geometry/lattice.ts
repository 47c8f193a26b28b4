import { lattice } from '../../scene/lattice.ts';
import { definePrimitive, metres, pieces } from './primitive.ts';

/** Bars along the edges of cubes, its middle at the origin: what bends at speed is seen best of straight lines. */
export const latticeNode = definePrimitive({
  id: 'lattice',
  title: 'node.lattice',
  help: 'node.lattice.help',
  name: 'Lattice',
  params: {
    x: pieces('param.cellsX', 4, 0, 16),
    y: pieces('param.cellsY', 4, 0, 16),
    z: pieces('param.cellsZ', 4, 0, 16),
    cell: metres('param.cell', 1),
    thickness: metres('param.thickness', 0.06),
  },
  mesh: ({ x, y, z, cell, thickness }) => lattice([x, y, z], cell, thickness),
});
