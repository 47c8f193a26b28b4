import { Handle, Position } from '@xyflow/react';
import type { ReactNode } from 'react';
import type { SocketModel } from './cardModel.ts';

interface SocketHandleProps {
  readonly side: 'inputs' | 'outputs';
  readonly socket: SocketModel;
  /** No edge can be drawn to or from it here. */
  readonly closed: boolean;
  /** The edge being drawn does not fit it. */
  readonly unfit: boolean;
}

/** A socket: its colour and shape show the type. */
export function SocketHandle({ side, socket, closed, unfit }: SocketHandleProps): ReactNode {
  const isInput = side === 'inputs';
  return (
    <Handle
      id={socket.name}
      type={isInput ? 'target' : 'source'}
      position={isInput ? Position.Left : Position.Right}
      isConnectable={!closed}
      className="sl-socket"
      data-unfit={unfit || undefined}
      data-socket={`${side === 'inputs' ? 'in' : 'out'} ${socket.name}`}
    >
      <span className="sl-mark" data-type={socket.type} data-free={!socket.connected || undefined} />
    </Handle>
  );
}
