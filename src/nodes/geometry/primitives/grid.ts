import { grid } from '../../../scene/mesh/primitives.ts';
import { axisParam, countParam, definePrimitive, lengthParam } from './definePrimitive.ts';

/** A flat rectangle of cells, double-sided. */
export const gridNode = definePrimitive({
  id: 'grid',
  title: 'node.grid',
  help: 'node.grid.help',
  name: 'Grid',
  params: {
    width: lengthParam('param.width', 10),
    length: lengthParam('param.length', 10),
    columns: countParam('param.columns', 10, 1, 1000),
    rows: countParam('param.rows', 10, 1, 1000),
    axis: axisParam,
  },
  mesh: ({ width, length, columns, rows, axis }) => grid(width, length, columns, rows, axis as 'Y'),
});
