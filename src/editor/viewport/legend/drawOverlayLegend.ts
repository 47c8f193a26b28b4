import { drawFrame, legendStyleOf, type Rectangle } from './drawLegend.ts';

/** As in overlayLegend.css: breadth and period of hatching [px]. */
const [STROKE, PERIOD] = [2, 6];

/** Draws the displayed legend of what is drawn over a picture into it, in a context scaled to CSS pixels. `picture`: the element below it. */
export function drawOverlayLegend(context: CanvasRenderingContext2D, element: HTMLElement, picture: HTMLElement): void {
  const look = legendStyleOf(element, picture);
  const under = picture.getBoundingClientRect();
  drawFrame(context, look, element.getBoundingClientRect().height);
  for (const row of element.querySelectorAll('li')) {
    const [sign, text] = row.children as unknown as readonly [HTMLElement, HTMLElement];
    const boxOf = (part: HTMLElement): Rectangle => {
      const { x, y, width, height } = part.getBoundingClientRect();
      return [x - under.x, y - under.y, width, height];
    };
    drawSign(context, sign.dataset.mark === 'contour' ? 'line' : sign.dataset.mark === 'past' ? 'falling' : 'rising', {
      box: boxOf(sign),
      color: getComputedStyle(sign).color,
      line: look.line,
    });
    const [x, y, , height] = boxOf(text);
    const { fontSize } = getComputedStyle(text);
    context.font = `${fontSize} ${look.font}`;
    context.textBaseline = 'middle';
    context.fillStyle = look.ink;
    context.fillText(text.textContent, x, y + height / 2);
  }
}

interface Sign {
  readonly box: Rectangle;
  readonly color: string;
  readonly line: string;
}

function drawSign(
  context: CanvasRenderingContext2D,
  style: 'line' | 'falling' | 'rising',
  { box, color, line }: Sign,
): void {
  const [x, y, width, height] = box;
  if (style === 'line') {
    context.fillStyle = '#000';
    context.fillRect(x, y, width, height);
    context.fillStyle = color;
    context.fillRect(x, y + 1, width, height - 2);
    return;
  }
  context.save();
  context.beginPath();
  context.rect(...box);
  context.clip();
  context.beginPath();
  const [start, end] = style === 'falling' ? [y, y + height] : [y + height, y];
  for (let left = x - height; left < x + width; left += PERIOD * Math.SQRT2) {
    context.moveTo(left, start);
    context.lineTo(left + height, end);
  }
  context.strokeStyle = color;
  context.lineWidth = STROKE;
  context.stroke();
  context.restore();
  context.strokeStyle = line;
  context.lineWidth = 1;
  context.strokeRect(x + 0.5, y + 0.5, width - 1, height - 1);
}
