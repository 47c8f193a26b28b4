import { msg } from '../../../messages/message.ts';
import { grid } from '../../../scene/mesh/primitives.ts';
import { axisParam, countParam, definePrimitive, lengthParam } from './definePrimitive.ts';

/** A flat rectangle of cells, double-sided. */
export const gridNode = definePrimitive({
  id: 'grid',
  title: msg`Grid`,
  help: msg`A flat rectangle of cells, visible from both sides.`,
  name: 'Grid',
  params: {
    width: lengthParam(msg`Width`, 10),
    length: lengthParam(msg`Length`, 10),
    columns: countParam(msg`Columns`, 10, 1, 1000),
    rows: countParam(msg`Rows`, 10, 1, 1000),
    axis: axisParam,
  },
  mesh: ({ width, length, columns, rows, axis }) => grid(width, length, columns, rows, axis as 'Y'),
});
