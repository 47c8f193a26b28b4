import { Tooltip } from '@mantine/core';
import { IconAlertTriangle, IconEyeOff, IconHourglass, IconSitemap } from '@tabler/icons-react';
import type { NodeProps } from '@xyflow/react';
import { memo, type ReactNode, useContext } from 'react';
import { GROUP } from '../../../graph/document/structuralTypes.ts';
import type { CanvasPoint } from '../../../graph/edits/commands.ts';
import { msg } from '../../../messages/message.ts';
import { isFileNode } from '../../../nodes/project/fileNodes.ts';
import { useTexts } from '../../language/languageStore.ts';
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
export const NodeCard = memo(function NodeCard({ data: { card, reach } }: NodeProps<CardNode>): ReactNode {
  const fits = useCompatibleSockets(card.id);
  const pixel = useContext(CanvasPixelContext);
  return (
    <article
      className="sl-node"
      data-category={card.category}
      data-muted={card.muted || undefined}
      data-collapsed={card.collapsed || undefined}
      data-picture={(!card.collapsed && card.picture) || undefined}
      data-problem={card.problem?.severity}
      data-unfit={(fits && fits.size === 0) || undefined}
    >
      <Head card={card} />
      {pixel !== undefined && <ZoomedOutLabel card={card} reach={reach} pixel={pixel} />}
      {card.collapsed ? <CollapsedSockets card={card} /> : <Body card={card} fits={fits} />}
    </article>
  );
});

function Head({ card }: { readonly card: CardModel }): ReactNode {
  const { t } = useTexts();
  return (
    <header className="sl-node-head">
      {card.type === GROUP && <EnterButton id={card.id} />}
      <span className="sl-node-title" title={card.kind && `${t(card.title)} (${t(card.kind)})`}>
        {t(card.title)}
      </span>
      <NodeProgress id={card.id} />
      {!card.muted && isFileNode(card.type) && <SaveMark id={card.id} />}
      {card.muted && <IconEyeOff size={14} aria-label={t(msg`muted`)} />}
      {card.problem ? (
        <Tooltip label={t(msg`${card.problem.place}: ${card.problem.message}`)} multiline maw={340} withinPortal>
          <span className="sl-node-problem" data-severity={card.problem.severity}>
            <IconAlertTriangle size={15} aria-hidden />
          </span>
        </Tooltip>
      ) : (
        card.blocked && <IconHourglass size={14} aria-label={t(msg`waits for an upstream node`)} />
      )}
    </header>
  );
}

interface ZoomedOutLabelProps {
  readonly card: CardModel;
  readonly reach: CanvasPoint;
  readonly pixel: number;
}

/** Label of a zoomed-out node: its title, centered or above its picture. */
function ZoomedOutLabel({ card, reach, pixel }: ZoomedOutLabelProps): ReactNode {
  const { t } = useTexts();
  const room = titleArea(card, pixel <= MAX_PICTURE_PIXEL);
  const set = layoutTitle(t(card.title), room, reach, pixel);
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
  const editor = useEditor();
  const flat = useCanvas(({ path }) => flatNodeId(existingPath(editor.store.getState().history.document, path), id));
  return <SaveFileIcon node={flat} />;
}

function EnterButton({ id }: { readonly id: string }): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const open = () => {
    const context = actionContext(editor);
    if (context) enterGroup(context, id);
  };
  return (
    <button
      type="button"
      className="sl-node-enter nodrag"
      tabIndex={-1}
      aria-label={t(msg`Enter the group`)}
      title={t(msg`Enter the group`)}
      onClick={open}
    >
      <IconSitemap size={14} />
    </button>
  );
}

/** All at one point; only edge ends are needed. */
const CollapsedSockets = ({ card }: { readonly card: CardModel }): ReactNode =>
  card.rows.flatMap(({ input, output }) => [
    input && <SocketHandle key={`in ${input.name}`} side="inputs" socket={input} closed unfit={false} />,
    output && <SocketHandle key={`out ${output.name}`} side="outputs" socket={output} closed unfit={false} />,
  ]);

function Body({ card, fits }: { readonly card: CardModel; readonly fits?: ReadonlySet<string> }): ReactNode {
  const { t } = useTexts();
  return (
    <>
      {(card.rows.length > 0 || card.more > 0) && (
        <div className="sl-node-body">
          {card.rows.map((row, i) => (
            // biome-ignore lint/suspicious/noArrayIndexKey: rows have no id
            <RowLine key={i} row={row} fits={fits} />
          ))}
          {card.more > 0 && <div className="sl-node-row sl-node-more">{t(msg`+ ${card.more} more set`)}</div>}
        </div>
      )}
      {card.picture && <NodePicture card={card} />}
      {card.hasPreview && (
        <footer className="sl-node-foot">{card.preview ? <ValueText of={card.preview} /> : <span>–</span>}</footer>
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
  const { t } = useTexts();
  const unfit = (key: string) => fits !== undefined && !fits.has(key);
  return (
    <div className="sl-node-row" data-param={title ? true : undefined}>
      {input && <SocketHandle side="inputs" socket={input} closed={false} unfit={unfit(`inputs ${input.name}`)} />}
      <span className="sl-node-label">{title ? t(title) : input && <SocketLabel socket={input} />}</span>
      {title && <span className="sl-node-value">{value ? <ValueText of={value} /> : <em>{t(msg`driven`)}</em>}</span>}
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
  const { t } = useTexts();
  return (
    <>
      {t(socket.title)}
      {socket.number !== undefined && <span className="sl-node-number"> {socket.number}</span>}
    </>
  );
}

/** A reroute: a bend in an edge. */
export const RerouteDot = memo(function RerouteDot({ data: { card } }: NodeProps<CardNode>): ReactNode {
  const fits = useCompatibleSockets(card.id);
  const { input, output } = card.rows[0] ?? {};
  return (
    <div className="sl-dot" data-muted={card.muted || undefined}>
      {input && <SocketHandle side="inputs" socket={input} closed={false} unfit={fits?.has('inputs in') === false} />}
      {output && (
        <SocketHandle side="outputs" socket={output} closed={false} unfit={fits?.has('outputs out') === false} />
      )}
    </div>
  );
});
