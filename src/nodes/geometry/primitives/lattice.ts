import { lattice } from '../../../scene/mesh/lattice.ts';
import { countParam, definePrimitive, lengthParam } from './definePrimitive.ts';

/** Bars along the edges of cubes, centered at the origin; straight lines show relativistic distortion best. */
export const latticeNode = definePrimitive({
  id: 'lattice',
  title: 'node.lattice',
  help: 'node.lattice.help',
  name: 'Lattice',
  params: {
    x: countParam('param.cellsX', 4, 0, 16),
    y: countParam('param.cellsY', 4, 0, 16),
    z: countParam('param.cellsZ', 4, 0, 16),
    cell: lengthParam('param.cell', 1),
    thickness: lengthParam('param.thickness', 0.06),
  },
  mesh: ({ x, y, z, cell, thickness }) => lattice([x, y, z], cell, thickness),
});
