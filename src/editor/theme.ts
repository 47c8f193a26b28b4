import { Button, createTheme, type MantineColorsTuple, Modal, Select } from '@mantine/core';

/** Blue, the colour of blueshift. */
const azure: MantineColorsTuple = [
  '#eaf3ff',
  '#d5e4fb',
  '#aac7f2',
  '#7ba8ea',
  '#558de3',
  '#3d7cdf',
  '#2f73dd',
  '#2061c2',
  '#1857af',
  '#064a9b',
];

/** Neutral greys with a slight blue tint, so that the picture's colours are judged against a neutral surround. */
const dark: MantineColorsTuple = [
  '#d5d9e0',
  '#aeb5c0',
  '#8b94a3',
  '#667080',
  '#434b59',
  '#303744',
  '#252b36',
  '#1b2029',
  '#151920',
  '#0f1217',
];

const FONT =
  "'Inter Variable', -apple-system, 'Segoe UI', 'PingFang SC', 'Microsoft YaHei', 'Noto Sans CJK SC', 'WenQuanYi Micro Hei', sans-serif";

export const theme = createTheme({
  primaryColor: 'azure',
  primaryShade: { light: 7, dark: 4 },
  autoContrast: true,
  colors: { azure, dark },
  fontFamily: FONT,
  headings: { fontFamily: FONT, fontWeight: '600' },
  defaultRadius: 'sm',
  cursorType: 'pointer',
  focusRing: 'auto',
  respectReducedMotion: true,
  components: {
    Select: Select.extend({ classNames: { option: 'sl-option' } }),
    Button: Button.extend({ defaultProps: { fw: 500 } }),
    Modal: Modal.extend({ styles: { title: { fontSize: 'var(--mantine-font-size-lg)', fontWeight: 600 } } }),
  },
});
