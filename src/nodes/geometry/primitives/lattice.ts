import { msg } from '../../../messages/message.ts';
import { lattice } from '../../../scene/mesh/lattice.ts';
import { countParam, definePrimitive, lengthParam } from './definePrimitive.ts';

/** Bars along the edges of cubes, centered at the origin; straight lines show relativistic distortion best. */
export const latticeNode = definePrimitive({
  id: 'lattice',
  title: msg`Lattice`,
  help: msg`Bars along the edges of cubes: straight lines show relativistic distortion best.`,
  name: 'Lattice',
  params: {
    x: countParam(msg`Cells in x`, 4, 0, 16),
    y: countParam(msg`Cells in y`, 4, 0, 16),
    z: countParam(msg`Cells in z`, 4, 0, 16),
    cell: lengthParam(msg`Cell`, 1),
    thickness: lengthParam(msg`Thickness`, 0.06),
  },
  mesh: ({ x, y, z, cell, thickness }) => lattice([x, y, z], cell, thickness),
});
