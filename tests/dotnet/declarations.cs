// The declarations of a host, as they are usually written for gts.dll on Windows.
using System.Runtime.InteropServices;

namespace gts
{
    public class mc
    {
        public const short MC_GPO = 12;

        public struct TCrdPrm
        {
            public short dimension;
            public short profile1;
            public short profile2;
            public short profile3;
            public short profile4;
            public short profile5;
            public short profile6;
            public short profile7;
            public short profile8;
            public double synVelMax;
            public double synAccMax;
            public short evenTime;
            public short setOriginFlag;
            public int originPos1;
            public int originPos2;
            public int originPos3;
            public int originPos4;
            public int originPos5;
            public int originPos6;
            public int originPos7;
            public int originPos8;
        }

        [DllImport("gts.dll")]
        public static extern short GT_Open(short channel, short param);
        [DllImport("gts.dll")]
        public static extern short GT_Close();
        [DllImport("gts.dll")]
        public static extern short GT_AxisOn(short axis);
        [DllImport("gts.dll")]
        public static extern short GT_SetCrdPrm(short crd, ref TCrdPrm pCrdPrm);
        [DllImport("gts.dll")]
        public static extern short GT_CrdClear(short crd, short fifo);
        [DllImport("gts.dll")]
        public static extern short GT_LnXY(short crd, int x, int y, double synVel, double synAcc,
            double velEnd, short fifo);
        [DllImport("gts.dll")]
        public static extern short GT_BufIO(short crd, ushort doType, ushort doMask, ushort doValue,
            short fifo);
        [DllImport("gts.dll")]
        public static extern short GT_BufDelay(short crd, ushort delayTime, short fifo);
        [DllImport("gts.dll")]
        public static extern short GT_CrdStart(short mask, short option);
        [DllImport("gts.dll")]
        public static extern short GT_CrdStatus(short crd, out short pRun, out int pSegment,
            short fifo);
    }
}
