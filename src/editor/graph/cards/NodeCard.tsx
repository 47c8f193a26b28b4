import { Tooltip } from '@mantine/core';
import { IconAlertTriangle, IconEyeOff, IconHourglass, IconSitemap } from '@tabler/icons-react';
import type { NodeProps } from '@xyflow/react';
import { memo, type ReactNode, useContext } from 'react';
import { GROUP } from '../../../graph/document/structuralTypes.ts';
import type { CanvasPoint } from '../../../graph/edits/commands.ts';
import { isFileNode } from '../../../nodes/project/fileNodes.ts';
import { useTexts } from '../../i18n/i18n.ts';
import { SaveFileIcon } from '../../saving/SaveFileButton.tsx';
import { useEditor } from '../../state/context.tsx';
import { existingPath, flatNodeId, useCanvas } from '../canvas/canvasState.ts';
import type { CardNode } from '../canvas/flowElements.ts';
import { actionContext, enterGroup } from '../commands/actions.ts';
import { NodePicture } from '../pictures/NodePicture.tsx';
import { titleArea } from './cardGeometry.ts';
import type { CardModel, CardRow, SocketModel } from './cardModel.ts';
import { NodeProgress } from './NodeProgress.tsx';
import { SocketHandle } from './SocketHandle.tsx';
import { ValueText } from './ValueText.tsx';
import { CanvasPixelContext, LINE_HEIGHT, layoutTitle, MAX_PICTURE_PIXEL } from './zoomedOutTitle.ts';

const NONE: ReadonlySet<string> = new Set();

/** While an edge is drawn: the node's sockets that it fits; otherwise undefined. */
function useCompatibleSockets(id: string): ReadonlySet<string> | undefined {
  return useCanvas(({ compatibleSockets }) => compatibleSockets && (compatibleSockets.get(id) ?? NONE));
}

/** A node: title, sockets, set parameters, result and problem. */
export const NodeCard = memo(function NodeCard({ data: { face, reach } }: NodeProps<CardNode>): ReactNode {
  const fits = useCompatibleSockets(face.id);
  const pixel = useContext(CanvasPixelContext);
  return (
    <article
      className="sl-node"
      data-category={face.category}
      data-muted={face.muted || undefined}
      data-collapsed={face.collapsed || undefined}
      data-picture={(!face.collapsed && face.picture) || undefined}
      data-problem={face.problem ? 'error' : undefined}
      data-unfit={(fits && fits.size === 0) || undefined}
    >
      <Head face={face} />
      {pixel !== undefined && <ZoomedOutLabel face={face} reach={reach} pixel={pixel} />}
      {face.collapsed ? <CollapsedSockets face={face} /> : <Body face={face} fits={fits} />}
    </article>
  );
});

function Head({ face }: { readonly face: CardModel }): ReactNode {
  const { any, t, said } = useTexts();
  return (
    <header className="sl-node-head">
      {face.type === GROUP && <EnterButton id={face.id} />}
      <span className="sl-node-title" title={face.kind && `${any(face.title)} (${any(face.kind)})`}>
        {any(face.title)}
      </span>
      <NodeProgress id={face.id} />
      {!face.muted && isFileNode(face.type) && <SaveMark id={face.id} />}
      {face.muted && <IconEyeOff size={14} aria-label={t('graph.muted')} />}
      {face.problem ? (
        <Tooltip label={`${said(face.problem.place)}: ${said(face.problem.message)}`} multiline maw={340} withinPortal>
          <span className="sl-node-problem">
            <IconAlertTriangle size={15} aria-hidden />
          </span>
        </Tooltip>
      ) : (
        face.blocked && <IconHourglass size={14} aria-label={t('graph.waits')} />
      )}
    </header>
  );
}

interface ZoomedOutLabelProps {
  readonly face: CardModel;
  readonly reach: CanvasPoint;
  readonly pixel: number;
}

/** Label of a zoomed-out node: its title, centered or above its picture. */
function ZoomedOutLabel({ face, reach, pixel }: ZoomedOutLabelProps): ReactNode {
  const { any } = useTexts();
  const room = titleArea(face, pixel <= MAX_PICTURE_PIXEL);
  const set = layoutTitle(any(face.title), room, reach, pixel);
  if (!set) return null;
  const [x, y] = set.reach;
  const place = { left: -x, right: -x, top: -y, height: room[1] + 2 * y };
  return (
    <div className="sl-far" style={{ ...place, fontSize: set.size, lineHeight: LINE_HEIGHT }} aria-hidden>
      <span style={{ WebkitLineClamp: set.lines }}>{set.text}</span>
    </div>
  );
}

/** Saves the file that the node requests. */
function SaveMark({ id }: { readonly id: string }): ReactNode {
  const studio = useEditor();
  const flat = useCanvas(({ path }) => flatNodeId(existingPath(studio.store.getState().history.document, path), id));
  return <SaveFileIcon node={flat} />;
}

function EnterButton({ id }: { readonly id: string }): ReactNode {
  const { t } = useTexts();
  const studio = useEditor();
  const open = () => {
    const context = actionContext(studio);
    if (context) enterGroup(context, id);
  };
  return (
    <button
      type="button"
      className="sl-node-enter nodrag"
      tabIndex={-1}
      aria-label={t('graph.enter')}
      title={t('graph.enter')}
      onClick={open}
    >
      <IconSitemap size={14} />
    </button>
  );
}

/** All at one point; only edge ends are needed. */
const CollapsedSockets = ({ face }: { readonly face: CardModel }): ReactNode =>
  face.rows.flatMap(({ input, output }) => [
    input && <SocketHandle key={`in ${input.name}`} side="inputs" socket={input} closed unfit={false} />,
    output && <SocketHandle key={`out ${output.name}`} side="outputs" socket={output} closed unfit={false} />,
  ]);

function Body({ face, fits }: { readonly face: CardModel; readonly fits?: ReadonlySet<string> }): ReactNode {
  const { t } = useTexts();
  return (
    <>
      {(face.rows.length > 0 || face.more > 0) && (
        <div className="sl-node-body">
          {face.rows.map((row, i) => (
            // biome-ignore lint/suspicious/noArrayIndexKey: rows have no id
            <RowLine key={i} row={row} fits={fits} />
          ))}
          {face.more > 0 && <div className="sl-node-row sl-node-more">{t('graph.more', { count: face.more })}</div>}
        </div>
      )}
      {face.picture && <NodePicture face={face} />}
      {face.tells && (
        <footer className="sl-node-foot">{face.preview ? <ValueText of={face.preview} /> : <span>–</span>}</footer>
      )}
    </>
  );
}

function RowLine({
  row: { input, output, title, value },
  fits,
}: {
  readonly row: CardRow;
  readonly fits?: ReadonlySet<string>;
}) {
  const { any, t } = useTexts();
  const unfit = (key: string) => fits !== undefined && !fits.has(key);
  return (
    <div className="sl-node-row" data-param={title ? true : undefined}>
      {input && <SocketHandle side="inputs" socket={input} closed={false} unfit={unfit(`inputs ${input.name}`)} />}
      <span className="sl-node-label">{title ? any(title) : input && <SocketLabel socket={input} />}</span>
      {title && (
        <span className="sl-node-value">{value ? <ValueText of={value} /> : <em>{t('graph.driven')}</em>}</span>
      )}
      {output && (
        <>
          <span className="sl-node-label sl-node-out">
            <SocketLabel socket={output} />
          </span>
          <SocketHandle side="outputs" socket={output} closed={false} unfit={unfit(`outputs ${output.name}`)} />
        </>
      )}
    </div>
  );
}

function SocketLabel({ socket }: { readonly socket: SocketModel }): ReactNode {
  const { any } = useTexts();
  return (
    <>
      {any(socket.title)}
      {socket.number !== undefined && <span className="sl-node-number"> {socket.number}</span>}
    </>
  );
}

/** A reroute: a bend in an edge. */
export const RerouteDot = memo(function RerouteDot({ data: { face } }: NodeProps<CardNode>): ReactNode {
  const fits = useCompatibleSockets(face.id);
  const { input, output } = face.rows[0] ?? {};
  return (
    <div className="sl-dot" data-muted={face.muted || undefined}>
      {input && <SocketHandle side="inputs" socket={input} closed={false} unfit={fits?.has('inputs in') === false} />}
      {output && (
        <SocketHandle side="outputs" socket={output} closed={false} unfit={fits?.has('outputs out') === false} />
      )}
    </div>
  );
});
