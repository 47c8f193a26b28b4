import { BaseEdge, type EdgeProps, getBezierPath } from '@xyflow/react';
import { memo, type ReactNode } from 'react';
import type { WireEdge } from './flowElements.ts';

/** An edge in the colour of its data type. */
export const Wire = memo(function Wire(props: EdgeProps<WireEdge>): ReactNode {
  const { id, sourceX, sourceY, targetX, targetY, sourcePosition, targetPosition, data, selected } = props;
  const [path] = getBezierPath({ sourceX, sourceY, targetX, targetY, sourcePosition, targetPosition });
  return (
    <g
      className="sl-wire"
      data-type={data?.type}
      data-conflict={data?.conflict || undefined}
      data-selected={selected || undefined}
    >
      <path d={path} className="sl-wire-edge" />
      <BaseEdge id={id} path={path} interactionWidth={16} />
    </g>
  );
});
