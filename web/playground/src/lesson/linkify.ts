// Stands for the package `linkify-it` in the bundle (tools/bundle.js), which finds addresses in texts.
// Those of lessons stay text (markdown.ts), so that the page does not bring it.
export default Object;
