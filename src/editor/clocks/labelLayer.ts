import { type Clock, clockTime } from '../../scene/clocks/clock.ts';
import { formatSeconds } from '../format.ts';
import type { PreviewContext } from '../viewport/viewportRenderer.ts';
import { labelPlaces, type PointLabel } from './labelPlaces.ts';
import { OcclusionProbe } from './occlusionProbe.ts';
import { type PicturedClock, picturedClock } from './picturedClock.ts';

/** The elements of a label. */
interface LabelElements {
  readonly whole: HTMLElement;
  readonly point: HTMLElement;
  readonly text: HTMLElement;
  readonly time: HTMLElement;
}

/** A label in the picture that is shown. */
interface ShownLabel extends PicturedClock {
  readonly path: string;
  readonly label: LabelElements;
}

/** Points and texts over the picture, beside the things whose clocks they show; they are dimmed where nearer things hide these. */
export class LabelLayer {
  readonly element = document.createElement('div');
  private readonly probe = new OcclusionProbe<PreviewContext['view']>();
  private clocks: readonly Clock[] = [];
  private labels: readonly LabelElements[] = [];
  private view: PreviewContext['view'] | undefined;
  private shown: readonly ShownLabel[] = [];
  /** Where texts were, from their points [px]. */
  private readonly last = new Map<string, PointLabel['last']>();

  constructor() {
    this.element.className = 'sl-clock-labels';
    this.element.ariaHidden = 'true';
  }

  /** Brings the labels to where a picture shows clocks. `now` [ms]. */
  follow(clocks: readonly Clock[], { view, renderer }: PreviewContext, now: number): void {
    const isNew = this.clocks !== clocks;
    if (isNew) {
      this.clocks = clocks;
      this.labels = clocks.map(newLabel);
      this.element.replaceChildren(...this.labels.map(({ whole }) => whole));
    }
    if (isNew || this.view !== view) this.draw(view, renderer);
    this.view = view;
    this.look(view, renderer, now);
  }

  private draw({ viewPoint, settings }: PreviewContext['view'], size: PreviewContext['renderer']): void {
    const frame = { width: this.element.clientWidth, height: this.element.clientHeight };
    this.shown = this.clocks.flatMap((clock, i) => {
      const label = this.labels[i]!;
      const seen = picturedClock(clock, viewPoint, settings, size);
      label.whole.hidden = !seen;
      if (!seen) return [];
      label.time.textContent = formatSeconds(clockTime(clock, seen.time, settings.speedOfLight));
      return [{ ...seen, path: clock.path, label }];
    });
    const sized = this.shown.map(({ path, place: [x, y], label: { text } }) => ({
      x: x * frame.width,
      y: y * frame.height,
      width: text.offsetWidth,
      height: text.offsetHeight,
      last: this.last.get(path),
    }));
    const places = labelPlaces(sized, frame);
    this.last.clear();
    this.shown.forEach(({ path, label: { whole, point, text } }, i) => {
      const { x, y } = sized[i]!;
      const place = places[i];
      point.style.transform = `translate(${x}px, ${y}px)`;
      text.style.visibility = place ? '' : 'hidden';
      if (place) {
        text.style.transform = `translate(${place[0]}px, ${place[1]}px)`;
        this.last.set(path, [place[0] - x, place[1] - y]);
      }
      whole.toggleAttribute('data-behind', this.probe.isHidden(path));
    });
  }

  /** Looks whether one of them is hidden by now. */
  private look(view: PreviewContext['view'], renderer: PreviewContext['renderer'], now: number): void {
    const { width, height } = renderer;
    const pick = async (x: number, y: number) => renderer.pick?.(x, y);
    this.probe
      .update({ view, width, height, pick }, this.shown, now)
      ?.then(() => {
        for (const { path, label } of this.shown) label.whole.toggleAttribute('data-behind', this.probe.isHidden(path));
      })
      // A lost device draws again, and is asked again.
      .catch(() => {});
  }
}

/** A point, and a text with the last part of the path and the time. */
function newLabel({ path }: Clock): LabelElements {
  const whole = document.createElement('div');
  const point = document.createElement('i');
  const text = document.createElement('span');
  const time = document.createElement('b');
  whole.dataset.clock = path;
  text.append(`${path.slice(path.lastIndexOf('/') + 1)} `, time);
  whole.append(point, text);
  return { whole, point, text, time };
}
