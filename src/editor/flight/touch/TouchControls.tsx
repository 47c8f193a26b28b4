import './touch.css';
import { IconArrowBigDown, IconArrowBigUp, IconHandStop } from '@tabler/icons-react';
import {
  type KeyboardEvent,
  type PointerEvent,
  type ReactNode,
  type RefObject,
  useEffect,
  useMemo,
  useState,
} from 'react';
import { useStore } from 'zustand';
import { driveMode } from '../../../flight/modes/drive.ts';
import { thrustMode, vehicleMode } from '../../../flight/modes/thrust.ts';
import { msg } from '../../../messages/message.ts';
import { formatBeta } from '../../format.ts';
import { useTexts } from '../../language/languageStore.ts';
import { useServices } from '../../services.tsx';
import { useEditorState } from '../../state/context.tsx';
import { ScreenControls, sliderSpeed, speedPosition, throttleOf } from './screenControls.ts';
import { useTouchGestures } from './useTouchGestures.ts';

interface TouchControlsProps {
  readonly picture: RefObject<HTMLElement | null>;
}

/** Flies by touch: a thrust pad under the left thumb, throttle, brake, up and down under the right one. */
export default function TouchControls({ picture }: TouchControlsProps): ReactNode {
  const { t } = useTexts();
  const { observerController } = useServices();
  const mode = useEditorState(({ flightMode }) => flightMode.template);
  const [controls] = useState(() => new ScreenControls());
  useTouchGestures(picture);
  useEffect(() => {
    const { inputs } = observerController;
    inputs.screen = controls;
    return () => {
      controls.letGo();
      inputs.screen = undefined;
    };
  }, [controls, observerController]);
  // The picture has the keys, and needs no hint, once one flies.
  const toPicture = () => picture.current?.focus({ preventScroll: true });
  const { store } = controls;
  return (
    <section className="sl-touch" aria-label={t(msg`Flight controls`)} onPointerDownCapture={toPicture}>
      <ThrustPad controls={controls} />
      <div className="sl-touch-right">
        <div className="sl-touch-buttons">
          {mode !== driveMode.title.template && (
            <>
              <HoldButton label={t(msg`Rise`)} hold={(held) => store.setState({ rise: held ? 1 : 0 })}>
                <IconArrowBigUp size={22} />
              </HoldButton>
              <HoldButton label={t(msg`Sink`)} hold={(held) => store.setState({ rise: held ? -1 : 0 })}>
                <IconArrowBigDown size={22} />
              </HoldButton>
            </>
          )}
          <HoldButton
            label={t(msg`Brake`)}
            hold={(held) => {
              if (held) controls.letGo();
              store.setState({ brake: held });
            }}
          >
            <IconHandStop size={22} />
          </HoldButton>
        </div>
        <Throttle
          controls={controls}
          isEngine={mode === thrustMode.title.template || mode === vehicleMode.title.template}
        />
      </div>
    </section>
  );
}

/** Directions of the pad by the arrow keys, to the right and back. */
const PAD_KEYS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
};

/** Where the finger is, from the middle of the pad, is where the thrust points. */
function ThrustPad({ controls }: { readonly controls: ScreenControls }): ReactNode {
  const { t } = useTexts();
  const pad = useStore(controls.store, (state) => state.pad);
  const hold = ({ currentTarget, clientX, clientY }: PointerEvent<HTMLElement>) => {
    const { left, top, width, height } = currentTarget.getBoundingClientRect();
    const radius = width / 2;
    controls.holdPad([(clientX - left - radius) / radius, (clientY - top - height / 2) / radius]);
  };
  const letGo = () => controls.holdPad(undefined);
  const label = t(msg`Thrust pad: drag up to accelerate forwards; beyond its rim at full speed`);
  const { right = 0, back = 0, isBeyond } = pad ?? {};
  return (
    <button
      type="button"
      className="sl-touch-pad"
      aria-label={label}
      data-beyond={isBeyond || undefined}
      onPointerDown={(event) => {
        event.preventDefault();
        event.currentTarget.setPointerCapture(event.pointerId);
        hold(event);
      }}
      onPointerMove={(event) => event.currentTarget.hasPointerCapture(event.pointerId) && hold(event)}
      onLostPointerCapture={letGo}
      onKeyDown={({ code }) => PAD_KEYS[code] && controls.holdPad(PAD_KEYS[code])}
      onKeyUp={letGo}
      onBlur={letGo}
      onContextMenu={(event) => event.preventDefault()}
    >
      <span className="sl-touch-knob" style={{ translate: `${50 * right}px ${50 * back}px` }} />
    </button>
  );
}

interface HoldButtonProps {
  readonly label: string;
  readonly hold: (held: boolean) => void;
  readonly children: ReactNode;
}

/** Acts as long as it is held, by finger or by key. */
function HoldButton({ label, hold, children }: HoldButtonProps): ReactNode {
  const [held, setHeld] = useState(false);
  const change = (to: boolean) => {
    if (to === held) return;
    setHeld(to);
    hold(to);
  };
  const isPress = ({ code }: KeyboardEvent): boolean => code === 'Space' || code === 'Enter';
  return (
    <button
      type="button"
      className="sl-touch-button"
      aria-label={label}
      data-held={held || undefined}
      onPointerDown={(event) => {
        event.preventDefault();
        event.currentTarget.setPointerCapture(event.pointerId);
        change(true);
      }}
      onLostPointerCapture={() => change(false)}
      onKeyDown={(event) => isPress(event) && change(true)}
      onKeyUp={() => change(false)}
      onBlur={() => change(false)}
      onContextMenu={(event) => event.preventDefault()}
    >
      {children}
    </button>
  );
}

interface ThrottleProps {
  readonly controls: ScreenControls;
  /** Whether it pushes; otherwise it asks for a speed. */
  readonly isEngine: boolean;
}

/** How hard one flies without a finger on the pad: the speed that is held, or the part of the engine's thrust. */
function Throttle({ controls, isEngine }: ThrottleProps): ReactNode {
  const { t } = useTexts();
  const throttle = useStore(controls.store, (state) => state.throttle);
  const maxSpeed = useEditorState(({ picture }) => picture?.maxSpeed ?? 0.5);
  const [toPosition, toThrottle] = useMemo(
    () =>
      isEngine
        ? [(part: number) => part, (position: number) => position]
        : [
            (part: number) => speedPosition(part * maxSpeed, maxSpeed),
            (position: number) => throttleOf(sliderSpeed(position, maxSpeed), maxSpeed),
          ],
    [isEngine, maxSpeed],
  );
  const text = isEngine ? `${Math.round(100 * throttle)} %` : `${formatBeta(throttle * maxSpeed)} c`;
  return (
    <div className="sl-touch-throttle">
      <input
        type="range"
        min={0}
        max={1}
        step={0.01}
        aria-label={isEngine ? t(msg`Throttle`) : t(msg`Speed that is held`)}
        aria-valuetext={text}
        value={toPosition(throttle)}
        onChange={({ currentTarget }) => controls.store.setState({ throttle: toThrottle(Number(currentTarget.value)) })}
      />
      <output className="sl-figure" aria-hidden>
        {text}
      </output>
    </div>
  );
}
